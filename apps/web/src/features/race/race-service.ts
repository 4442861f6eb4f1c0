/**
 * Manages races: adds a recorded run as a ghost, removes a ghost, ends the race. It ensures that
 * all runs of a race use the maze on the screen.
 */
import { countLines } from "@corridor/program";
import { isSameLayout } from "@corridor/maze";
import type { RunDocument } from "@corridor/recording";
import type { i18n } from "i18next";
import { saveRun } from "../../model/run/run-requests.ts";
import type { Services } from "../../model/services.ts";
import { storageOrNone, type KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import type { RaceGhost } from "../../model/run/race-store.ts";
import { showMessage } from "../../model/screen/screen-store.ts";
import { GHOST_BADGES, MAX_GHOSTS } from "../../stage/drawing/frame.ts";
import { readGhosts, storeGhosts } from "./race-storage.ts";
import {
  type AddedGhost,
  type Finish,
  type FromWorker,
} from "../../simulator/protocol/worker-messages.ts";

export type RacePorts = Pick<Services, "race" | "run" | "screen" | "simulator" | "workspace">;

/** Why a run is not in the race. */
export type RaceRefusal =
  | "full"
  | "empty"
  | "other-maze"
  /** the maze changed during the run */
  | "edited"
  /** the race already contains the run */
  | "same"
  | "too-long"
  /** the digest of a replay differs from the digest in the document */
  | "broken"
  | "failed";

export class RaceService {
  readonly #ports: RacePorts & { tab: KeyValueStorage };
  readonly #words: Pick<i18n, "t">;
  /** the runs of the ghosts, by ghost id */
  readonly #runs = new Map<number, RunDocument>();
  readonly #waiting = new Map<number, (added: AddedGhost) => void>();
  #lastId = 0;

  /** @param ports `tab` is sessionStorage */
  constructor(ports: RacePorts & { tab: KeyValueStorage }, words: Pick<i18n, "t">) {
    this.#ports = ports;
    this.#words = words;
    const { simulator, workspace, run, race } = ports;
    const event = run.getState().event;
    if (event?.kind === "goal") race.setState({ you: finishOf(event) });
    simulator.listen((message) => this.#receive(message));
    workspace.subscribe(({ maze }, before) => {
      if (isSameLayout(maze, before.maze) || race.getState().ghosts.length === 0) return;
      this.end();
      showMessage(ports.screen, { tone: "info", text: this.#words.t("race:over") });
    });
  }

  /** Makes the run on the screen a ghost, and resets the robot to the start that both share. */
  async raceThisRun(): Promise<void> {
    const { simulator, screen } = this.#ports;
    const saved = await new Promise<Parameters<Parameters<typeof saveRun>[1]>[0]>((resolve) =>
      saveRun(simulator, resolve),
    );
    const run = saved.ok ? (JSON.parse(saved.text) as RunDocument) : null;
    const refusal = run === null ? "too-long" : await this.add(run);
    if (refusal === null) {
      simulator.send({ type: "reset" });
      return;
    }
    showMessage(screen, { tone: "bad", text: this.refusalText(refusal, run) });
  }

  /** @returns why the run is not in the race; null if it is */
  async add(run: RunDocument): Promise<RaceRefusal | null> {
    const refused = this.#refusalOf(run);
    if (refused !== null) return refused;
    const badge = GHOST_BADGES.find((each) => !this.#isIn(each));
    if (badge === undefined) return "full";
    const refusal = await this.#load(badge, run);
    if (refusal === null && this.#isIn(badge)) {
      showMessage(this.#ports.screen, {
        tone: "info",
        text: this.#words.t("race:ready", { badge }),
      });
    }
    return refusal;
  }

  /** Restores the ghosts that the tab has stored, without those of another maze. */
  async resume(): Promise<void> {
    const loads = readGhosts(this.#ports.tab).flatMap(({ badge, run }) =>
      this.#refusalOf(run) === null && !this.#isIn(badge) ? [this.#load(badge, run)] : [],
    );
    await Promise.all(loads);
    this.#store();
  }

  async #load(badge: string, run: RunDocument): Promise<RaceRefusal | null> {
    const { race, simulator } = this.#ports;
    const { ghosts } = race.getState();
    const id = ++this.#lastId;
    const ghost: RaceGhost = {
      id,
      badge,
      program: run.program.name,
      digest: digestOf(run),
      finish: null,
    };
    const all = [...ghosts, ghost].toSorted((a, b) => (a.badge < b.badge ? -1 : 1));
    race.setState({ ghosts: all });
    this.#runs.set(id, run);
    this.#store();
    const added = await new Promise<AddedGhost>((resolve) => {
      this.#waiting.set(id, resolve);
      simulator.send({ type: "add-ghost", id, badge, run });
    });
    const isStillIn = race.getState().ghosts.some((each) => each.id === id);
    if (!added.ok) {
      this.#delete(id);
      // A ghost that was removed while it loaded is not a failure.
      if (!isStillIn) return null;
      return added.problems.length > 0 ? "broken" : "failed";
    }
    const { finish } = added;
    race.setState((state) => ({
      ghosts: state.ghosts.map((each) => (each.id === id ? { ...each, finish } : each)),
    }));
    return null;
  }

  remove(id: number): void {
    this.#delete(id);
    this.#ports.simulator.send({ type: "remove-ghost", id });
    this.#waiting.get(id)?.({ ok: false, problems: [] });
  }

  /** Removes all ghosts. */
  end(): void {
    for (const { id } of this.#ports.race.getState().ghosts) this.remove(id);
  }

  /** @param run the refused run */
  refusalText(refusal: RaceRefusal, run: RunDocument | null): string {
    return this.#words.t(`race:refused.${refusal}`, {
      most: MAX_GHOSTS,
      robots: MAX_GHOSTS + 1,
      name: run?.maze.name ?? "",
    });
  }

  #delete(id: number): void {
    const { race } = this.#ports;
    race.setState(({ ghosts }) => ({ ghosts: ghosts.filter((each) => each.id !== id) }));
    if (this.#runs.delete(id)) this.#store();
  }

  #isIn(badge: string): boolean {
    return this.#ports.race.getState().ghosts.some((ghost) => ghost.badge === badge);
  }

  /** Stores the ghosts for a reload. */
  #store(): void {
    const { race, tab } = this.#ports;
    const ghosts = race.getState().ghosts.flatMap(({ id, badge }) => {
      const run = this.#runs.get(id);
      return run === undefined ? [] : [{ badge, run }];
    });
    storeGhosts(tab, ghosts);
  }

  #refusalOf(run: RunDocument): RaceRefusal | null {
    const { race, workspace } = this.#ports;
    const { ghosts } = race.getState();
    if (run.ticks === 0) return "empty";
    if (!isSameLayout(run.maze, workspace.getState().maze)) return "other-maze";
    const isEdited = run.inputs.some(
      (input) => input.do === "maze" && !isSameLayout(input.maze, run.maze),
    );
    if (isEdited) return "edited";
    if (ghosts.some(({ digest }) => digest === digestOf(run))) return "same";
    return ghosts.length >= MAX_GHOSTS ? "full" : null;
  }

  #receive(message: FromWorker): void {
    const { race } = this.#ports;
    if (message.type === "ghost-added") {
      this.#waiting.get(message.id)?.(message.added);
      this.#waiting.delete(message.id);
    } else if (message.type === "event" && message.event.kind === "goal") {
      race.setState({ you: finishOf(message.event) });
    } else if (message.type === "truncated") {
      const tick = race.getState().you?.goalTick ?? null;
      if (tick !== null && tick > message.after) race.setState({ you: null });
    } else if (message.type === "fault") {
      for (const answer of this.#waiting.values()) answer({ ok: false, problems: [] });
      this.#waiting.clear();
    }
  }
}

let service: RaceService | null = null;

/** The service of this page. */
export function raceService(ports: RacePorts, words: Pick<i18n, "t">): RaceService {
  service ??= new RaceService({ ...ports, tab: storageOrNone(() => sessionStorage) }, words);
  return service;
}

function digestOf({ digest, ticks }: RunDocument): string {
  return `${digest} ${ticks}`;
}

function finishOf(event: Extract<FromWorker, { type: "event" }>["event"]): Finish {
  const { tick, bumps, driver, program } = event;
  const lines = countLines(program?.rules ?? []);
  return { goalTick: tick, bumps, driver, lines };
}
