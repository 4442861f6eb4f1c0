/**
 * Opens a run in another maze as a project of its own: what was open before does not change, and a
 * message leads back to it. A failed run plays from two seconds before its end; another one opens at
 * its start.
 */
import { isProgram } from "@corridor/challenge";
import { isSameProgram, type ProgramDocument } from "@corridor/program";
import type { RunToRecord } from "../../simulator/protocol/pool-messages.ts";
import { recordRun } from "../../simulator/record-runs.ts";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";
import type { WorkerPool } from "../../simulator/worker-pool.ts";
import { failureStart } from "../check/failure-start.ts";
import { loadRun } from "../run/run-requests.ts";
import { watchAgain } from "../run/watch-again.ts";
import { dismiss, showMessage, type ScreenStore } from "../screen/screen-store.ts";
import { setProgram, type WorkspaceStore } from "../workspace/workspace-store.ts";
import type { ProjectService } from "./project-service.ts";

interface OpenerPorts {
  workspace: WorkspaceStore;
  screen: ScreenStore;
  projects: Pick<ProjectService, "begin" | "currentId">;
  simulator: Pick<SimulatorClient, "send" | "listen" | "isGone">;
}

/** What the messages say. */
interface OpenerWords {
  opened: string;
  notOpened: string;
  /** label of the button that leads back */
  back: string;
  /** whether the message is the only way back, so that it stays while the run is open */
  stays?: boolean;
}

/** How to return to what was open before, which stays the same from one run to the next. */
interface Home {
  /** the project of the open run */
  project: string;
  back: () => void;
}

export class RunOpener {
  readonly #ports: OpenerPorts;
  readonly #pool: Pick<WorkerPool, "run">;
  #home: Home | null = null;

  /** @param pool the workers that record the runs */
  constructor(ports: OpenerPorts, pool: Pick<WorkerPool, "run">) {
    this.#ports = ports;
    this.#pool = pool;
  }

  /**
   * @param doesFail whether the run ends with a failure
   * @returns false if the run cannot be opened; a message reports it, and nothing has changed
   */
  async open(run: RunToRecord, doesFail: boolean, words: OpenerWords): Promise<boolean> {
    const { projects, simulator, screen } = this.#ports;
    const written = await recordRun(this.#pool, run);
    const loaded = written?.ok === true ? await loadRun(simulator, written.run).loaded : null;
    if (loaded?.ok !== true) {
      showMessage(screen, { tone: "bad", text: words.notOpened });
      return false;
    }
    const home = this.backAction();
    const back = projects.begin(loaded.maze, loaded.program, true);
    const own = isProgram(run.attempt) ? this.#takingProgram(back, run.attempt) : back;
    this.#home = { project: projects.currentId(), back: home ?? own };
    if (doesFail) watchAgain(simulator, failureStart(run.ticks));
    else simulator.send({ type: "seek", tick: 0 });
    const id = showMessage(screen, {
      tone: "info",
      text: words.opened,
      ...(words.stays === true && { stays: true, isOfProject: true }),
      action: {
        label: words.back,
        run: () => {
          dismiss(screen, id);
          this.backAction()?.();
        },
      },
    });
    return true;
  }

  /** Returns a function that leads back; null if no run of another maze is open. */
  backAction(): (() => void) | null {
    const home = this.#home;
    return home?.project === this.#ports.projects.currentId() ? home.back : null;
  }

  /** Takes changes of the program along, as one step of the history that Undo reverts. */
  #takingProgram(back: () => void, tried: ProgramDocument): () => void {
    const { workspace } = this.#ports;
    return () => {
      const { program } = workspace.getState();
      this.#home = null;
      back();
      if (!isSameProgram(program, tried)) setProgram(workspace, program);
    };
  }
}
