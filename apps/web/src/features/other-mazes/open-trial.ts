/**
 * Opens a maze that the program was tried in, as a project of its own: the student's maze does not
 * change. A failed run plays from two seconds before its end; a run that works opens at its start.
 */
import { isSameProgram, type ProgramDocument } from "@corridor/program";
import { TICKS_PER_SECOND } from "@corridor/simulation";
import type { i18n } from "i18next";
import { loadRun } from "../../model/run/run-requests.ts";
import type { Services } from "../../model/services.ts";
import { dismiss, showMessage } from "../../model/screen/screen-store.ts";
import { setProgram } from "../../model/workspace/workspace-store.ts";
import type { TrialMazes, TrialResult } from "../../simulator/protocol/trial-messages.ts";
import { recordRun } from "../../simulator/record-runs.ts";
import type { WorkerPool } from "../../simulator/worker-pool.ts";
import { watchAgain } from "../../model/run/watch-again.ts";

/** Ticks of the run that are played before it fails. */
const SHOWN_TICKS = 2 * TICKS_PER_SECOND;

type Opener = Pick<Services, "projects" | "workspace" | "simulator" | "screen">;

/** How to return to the student's own maze, which stays the same from one trial to the next. */
interface Home {
  /** the project of the open trial */
  trial: string;
  back: () => void;
}

export class TrialOpener {
  readonly #services: Opener;
  readonly #words: Pick<i18n, "t">;
  readonly #pool: Pick<WorkerPool, "run">;
  #home: Home | null = null;

  /** @param pool the workers that record the runs */
  constructor(services: Opener, words: Pick<i18n, "t">, pool: Pick<WorkerPool, "run">) {
    this.#services = services;
    this.#words = words;
    this.#pool = pool;
  }

  /** @returns false if the trial cannot be opened; a message reports it, and nothing has changed */
  async open(
    { maze, seed, outcome, tick }: TrialResult,
    { kind, side }: TrialMazes,
    program: ProgramDocument,
  ): Promise<boolean> {
    const { projects, simulator, screen } = this.#services;
    const { t } = this.#words;
    const name = t(`presets.random.names.${kind}`, { side, seed });
    const named = { ...maze, name };
    const run = { maze: named, attempt: program, ticks: tick };
    const written = await recordRun(this.#pool, run);
    const loaded = written?.ok === true ? await loadRun(simulator, written.run).loaded : null;
    if (loaded?.ok !== true) {
      showMessage(screen, { tone: "bad", text: t("otherMazes:notOpened") });
      return false;
    }
    const home = this.backAction();
    const back = projects.begin(loaded.maze, loaded.program, true);
    this.#home = { trial: projects.currentId(), back: home ?? this.#takingProgram(back, program) };
    if (outcome === "works") simulator.send({ type: "seek", tick: 0 });
    else watchAgain(simulator, tick - SHOWN_TICKS);
    const id = showMessage(screen, {
      tone: "info",
      text: t(`otherMazes:opened.${outcome}`, { name }),
      action: {
        label: t("otherMazes:back"),
        run: () => {
          dismiss(screen, id);
          this.backAction()?.();
        },
      },
    });
    return true;
  }

  /** Returns a function that leads back to the student's own maze; null if no trial is open. */
  backAction(): (() => void) | null {
    const home = this.#home;
    return home?.trial === this.#services.projects.currentId() ? home.back : null;
  }

  /** Takes changes of the program along, as one step of the history that Undo reverts. */
  #takingProgram(back: () => void, tried: ProgramDocument): () => void {
    const { workspace } = this.#services;
    return () => {
      const { program } = workspace.getState();
      this.#home = null;
      back();
      if (!isSameProgram(program, tried)) setProgram(workspace, program);
    };
  }
}
