/**
 * Opens a recorded run from a link or a file. Its maze and program become a project beside the
 * user's own. The run is displayed from its start, or plays from a given tick. It can be played,
 * rewound and continued.
 */
import type { FieldProblem } from "@corridor/protocol";
import type { RunDocument } from "@corridor/recording";
import type { i18n } from "i18next";
import {
  dismiss,
  showMessage,
  setMessageProgress,
  type ScreenStore,
} from "../screen/screen-store.ts";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";
import type { ProjectService } from "./project-service.ts";
import { loadRun } from "../run/run-requests.ts";
import { watchAgain } from "../run/watch-again.ts";

interface Opener {
  simulator: Pick<SimulatorClient, "send" | "listen" | "isGone">;
  projects: ProjectService;
  screen: ScreenStore;
}

/**
 * @param run a document that has passed its schema
 * @param from first tick to play; null displays the start of the run
 * @returns an empty list if the run was opened or cancelled; else its problems, and nothing has
 * changed
 */
export async function openRun(
  { simulator, projects, screen }: Opener,
  words: Pick<i18n, "t">,
  run: RunDocument,
  from: number | null = null,
): Promise<readonly FieldProblem[]> {
  const waiting = new WaitingMessage(screen, words, () => load.cancel());
  const onPart = (part: number) => {
    // A long run loads in the background: the page is usable, and a message reports the progress.
    screen.setState({ isOpening: false });
    waiting.report(part);
  };
  const load = loadRun(simulator, run, { onPart });
  const loaded = await load.loaded;
  waiting.end();
  if (!loaded.ok) return loaded.reason === "refused" ? loaded.problems : [];
  const back = projects.beginShared(loaded.maze, loaded.program, true);
  if (from === null) simulator.send({ type: "seek", tick: 0 });
  else watchAgain(simulator, from);
  const id = showMessage(screen, {
    tone: "info",
    text: words.t("timeline.recorded"),
    action: {
      label: words.t("share.back"),
      run: () => {
        dismiss(screen, id);
        back();
      },
    },
  });
  return [];
}

/** The message that reports the progress of a long run, with a button that cancels it. */
class WaitingMessage {
  readonly #screen: Opener["screen"];
  readonly #words: Pick<i18n, "t">;
  readonly #cancel: () => void;
  #id: number | null = null;

  constructor(screen: Opener["screen"], words: Pick<i18n, "t">, cancel: () => void) {
    this.#screen = screen;
    this.#words = words;
    this.#cancel = cancel;
  }

  /** @param part progress from 0 to 1 */
  report(part: number): void {
    if (this.#id === null) {
      const t = this.#words.t;
      this.#id = showMessage(this.#screen, {
        tone: "info",
        text: t("timeline.opening"),
        stays: true,
        part,
        action: { label: t("timeline.cancel"), run: this.#cancel },
      });
    } else setMessageProgress(this.#screen, this.#id, part);
  }

  end(): void {
    if (this.#id !== null) dismiss(this.#screen, this.#id);
  }
}
