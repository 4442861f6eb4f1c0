/**
 * Restores this tab's run after a reload. The worker stores the run; the tab stores its key and
 * which project was open when the page was left.
 */
import { isSameMaze } from "@corridor/maze";
import { isSameProgram } from "@corridor/program";
import type { WorkspaceStore } from "../workspace/workspace-store.ts";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";
import type { LoadedRun } from "../../simulator/protocol/worker-messages.ts";
import type { Frame } from "../../stage/drawing/frame.ts";
import { restoreRun, type RunLoad } from "./run-requests.ts";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";

const KEY = "corridor.run";
/** The documents that were open when the page was left, as one JSON text. */
const PROJECT_KEY = "corridor.run.project";

export interface RunRestorerPorts {
  simulator: Pick<SimulatorClient, "send" | "listen" | "isGone">;
  workspace: WorkspaceStore;
  /** sessionStorage */
  tab: KeyValueStorage;
  /** this device cannot store the run, and a reload starts at the start; called once */
  onNotStored: () => void;
  /** the run before the reload could not be restored */
  onLost: () => void;
}

export class RunRestorer {
  readonly #ports: RunRestorerPorts;
  #frame: Frame | null = null;
  /** the run that is being restored */
  #load: RunLoad | null = null;
  #hasReported = false;

  /** Starts to store the key of the worker's run. */
  constructor(ports: RunRestorerPorts) {
    this.#ports = ports;
    ports.simulator.listen((message) => {
      if (message.type === "run-key") this.#storeKey(message.key);
      if (message.type !== "frame") return;
      this.#frame = message.frame;
      // A user who drives or edits while a long run is restored has started another run.
      if (!this.#isUntouched()) this.#load?.cancel();
    });
  }

  /** Stores which project is open; synchronously, since the page may be closing. */
  flush(): void {
    if (this.#ports.tab.getItem(KEY) !== null) this.#write(PROJECT_KEY, this.#project());
  }

  /** Restores the stored run, unless another project is open now or the robot drives already. */
  async resume(): Promise<void> {
    const { tab, simulator, onLost } = this.#ports;
    const key = tab.getItem(KEY);
    if (key === null) return;
    const isSameProject = tab.getItem(PROJECT_KEY) === this.#project();
    this.#load = restoreRun(simulator, key, isSameProject);
    const loaded = await this.#load.loaded;
    this.#load = null;
    if (loaded.ok) this.#sendEdits(loaded);
    else if (loaded.reason !== "cancelled" && loaded.reason !== "other-project") onLost();
  }

  #storeKey(key: string | null): void {
    const { simulator, tab, onNotStored } = this.#ports;
    if (key === null) tab.removeItem(KEY);
    const ok = key === null || this.#write(KEY, key);
    simulator.send({ type: "run-key-noted", ok });
    if (key !== null || this.#hasReported) return;
    this.#hasReported = true;
    onNotStored();
  }

  /** Whether the robot is unchanged since the page started. */
  #isUntouched(): boolean {
    return (this.#frame?.nowTick ?? 0) === 0 && (this.#frame?.revision ?? 0) === 0;
  }

  /** Sends edits from just before the reload that the worker had not stored yet. */
  #sendEdits(loaded: Extract<LoadedRun, { ok: true }>): void {
    const { workspace, simulator } = this.#ports;
    const { maze, program } = workspace.getState();
    if (!isSameMaze(loaded.maze, maze)) simulator.send({ type: "edit-maze", maze });
    if (!isSameProgram(loaded.program, program)) simulator.send({ type: "edit-program", program });
  }

  #project(): string {
    const { maze, program } = this.#ports.workspace.getState();
    return JSON.stringify([maze, program]);
  }

  /** @returns whether the tab accepted the write */
  #write(key: string, text: string): boolean {
    try {
      this.#ports.tab.setItem(key, text);
      return true;
    } catch {
      return false;
    }
  }
}
