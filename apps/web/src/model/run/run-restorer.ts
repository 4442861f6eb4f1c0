/**
 * Restores this tab's run after a reload. The worker stores the run, at most a quarter of a second
 * late; the tab stores its key, and what was open when the page was left.
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
/**
 * When the run began, if its robot was displayed at its start then: a stored run from before a reset
 * began earlier. The robot may have moved since it was displayed.
 */
const START_KEY = "corridor.run.start";

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
  #hasResumed = false;

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

  /**
   * Stores what is open; synchronously, since the page may be closing. Before `resume` has ended,
   * the stored run is still the one from before this page.
   */
  flush(): void {
    if (!this.#hasResumed || this.#ports.tab.getItem(KEY) === null) return;
    this.#write(PROJECT_KEY, this.#project());
    if (this.#frame?.nowTick === 0) this.#write(START_KEY, String(this.#frame.startedAt));
    else this.#ports.tab.removeItem(START_KEY);
  }

  /** Restores the stored run, if it is the run that was left; see `restoreWorld`. */
  async resume(): Promise<void> {
    const key = this.#ports.tab.getItem(KEY);
    if (key !== null) await this.#restore(key);
    this.#hasResumed = true;
  }

  async #restore(key: string): Promise<void> {
    const { tab, simulator, onLost } = this.#ports;
    const isSameProject = tab.getItem(PROJECT_KEY) === this.#project();
    const start = tab.getItem(START_KEY);
    const atStartSince = start === null ? null : Number(start);
    this.#load = restoreRun(simulator, { key, isSameProject, atStartSince });
    const loaded = await this.#load.loaded;
    this.#load = null;
    if (loaded.ok) {
      // The frames so far are of the robot before it was restored.
      this.#frame = null;
      this.#sendEdits(loaded);
    } else if (loaded.reason !== "cancelled" && loaded.reason !== "other-run") onLost();
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
