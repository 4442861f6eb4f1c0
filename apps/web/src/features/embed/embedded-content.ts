/** What the page in a frame shows: the link or short link of its address, or of the site's request. */
import type { Rights } from "@corridor/challenge";
import { emptyProgram } from "@corridor/program";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { SharedContent, SharedLinkResult } from "../../model/address/shared-link.ts";
import type { ShortLinkResult } from "../../model/address/short-link.ts";
import { loadRun } from "../../model/run/run-requests.ts";
import type { Services } from "../../model/services.ts";
import type { FrameProblem } from "@corridor/protocol";

/** A link, as the part after its `#`, or the id of a short link. */
export type Wanted = { link: string } | { id: string };

export type View =
  | { kind: "opening" }
  /** `address`: of the same content in Corridor */
  | { kind: "open"; address: string }
  | { kind: "problem"; problem: FrameProblem };

export interface ContentPorts {
  services: Pick<Services, "challenge"> & {
    lessons: Pick<Services["lessons"], "openShared" | "handOver">;
    projects: Pick<Services["projects"], "beginShared">;
    simulator: Pick<Services["simulator"], "send" | "listen" | "isGone">;
    workspace: Pick<Services["workspace"], "getState">;
  };
  /** what students may do in a maze without a lesson */
  rights: Rights;
  decode: (link: string) => Promise<SharedLinkResult>;
  readShortLink: (id: string) => Promise<ShortLinkResult>;
  onOpened: (view: View) => void;
}

export class EmbeddedContent {
  readonly view: StoreApi<{ view: View }> = createStore(() => ({
    view: { kind: "opening" } as View,
  }));
  readonly #ports: ContentPorts;
  /** the newest request, which is opened next */
  #next: Wanted | null = null;
  #isOpening = false;
  #newest: Wanted | null = null;

  constructor(ports: ContentPorts) {
    this.#ports = ports;
  }

  /** Opens a link; of several at once, the first and the newest one. */
  async open(wanted: Wanted): Promise<void> {
    this.#next = wanted;
    if (this.#isOpening) return;
    this.#isOpening = true;
    while (this.#next !== null) {
      const now: Wanted = this.#next;
      this.#next = null;
      this.#newest = now;
      this.#show({ kind: "opening" });
      this.#show(await this.#tryOpen(now));
    }
    this.#isOpening = false;
  }

  /** Opens the newest link again, after a problem. */
  async retry(): Promise<void> {
    if (this.#newest !== null) await this.open(this.#newest);
  }

  /** Nothing was asked for. */
  openNothing(): void {
    this.#show({ kind: "problem", problem: "none" });
  }

  #show(view: View): void {
    this.view.setState({ view });
    if (view.kind !== "opening") this.#ports.onOpened(view);
  }

  async #tryOpen(wanted: Wanted): Promise<View> {
    try {
      return "link" in wanted ? await this.#openLink(wanted.link) : await this.#openId(wanted.id);
    } catch {
      return { kind: "problem", problem: "offline" };
    }
  }

  async #openLink(link: string): Promise<View> {
    const result = await this.#ports.decode(link);
    if (result.ok) return this.#openContent(result.value, `/#${link}`);
    const problem = result.code === "unknown-version" ? "newer" : "broken";
    return { kind: "problem", problem };
  }

  async #openId(id: string): Promise<View> {
    const result = await this.#ports.readShortLink(id);
    if (result.ok) return this.#openContent(result.value, `/m/${id}`);
    const problems = {
      "share.shortLink.gone": "gone",
      "share.shortLink.wait": "wait",
      "share.linkProblems.unknown-version": "newer",
    } as const;
    return { kind: "problem", problem: problems[result.sentence] };
  }

  async #openContent(content: SharedContent, address: string): Promise<View> {
    const { services, rights } = this.#ports;
    const { lessons, projects, simulator, workspace, challenge } = services;
    const { lesson, run, maze, program } = content;
    if (lesson !== undefined) {
      if (!(await lessons.openShared(lesson, program ?? null))) throw new Error("not loaded");
      await lessons.handOver();
      return { kind: "open", address };
    }
    if (run !== undefined) {
      const loaded = await loadRun(simulator, run).loaded;
      if (!loaded.ok) return { kind: "problem", problem: "broken" };
      projects.beginShared(loaded.maze, loaded.program, true);
      simulator.send({ type: "seek", tick: 0 });
    } else {
      // A maze alone is a task: its lines are still to be written.
      projects.beginShared(maze ?? workspace.getState().maze, program ?? emptyProgram());
    }
    challenge.setState({ rights, isInvited: false });
    return { kind: "open", address };
  }
}
