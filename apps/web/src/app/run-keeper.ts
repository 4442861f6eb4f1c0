/**
 * Keeps the run of this tab over a reload: the page comes back paused at the same tick.
 *
 * A page that goes has no time to ask the worker for anything. So the run is asked for whenever inputs
 * came to it; what it did since then without any is made again by running on to the tick that was
 * reached.
 */
import type { RunDocument } from "@corridor/recording";
import type { WorkspaceStore } from "../stores/workspace-store.ts";
import { loadRun, saveRun, type RunLoad } from "./run-requests.ts";
import type { SimulatorClient } from "../worker/simulator-client.ts";
import type { Frame } from "../worker/worker-messages.ts";
import type { KeyValueStorage } from "./works.ts";

const RUN_KEY = "corridor.run";
/** In place of a run that does not fit. */
const LOST = "lost";
/** At most so often the run is asked for; a long one more seldom, since writing it takes its time. */
const ASK_EVERY_MS = 300;
const CHARACTERS_PER_MS = 1000;

export interface RunKeeperPorts {
  simulator: Pick<SimulatorClient, "send" | "listen" | "isGone">;
  workspace: WorkspaceStore;
  /** sessionStorage */
  tab: KeyValueStorage;
  /** runs a function later, such as `setTimeout` */
  later: (run: () => void, milliseconds: number) => void;
  /** brings the reader of runs */
  loadReader: () => Promise<(text: string) => RunDocument | null>;
  /** the run before the reload could not be kept */
  onLost: () => void;
}

/** The run as it was when it was last asked for. */
interface Asked {
  revision: number;
  ticks: number;
  /** null where it is longer than a document may be */
  text: string | null;
}

export class RunKeeper {
  readonly #ports: RunKeeperPorts;
  #frame: Frame | null = null;
  #asked: Asked | null = null;
  #isWaiting = false;
  /** an answer that the worker still owes is out of date when it is asked again */
  #endAsking = (): void => {};
  /** whether what the page before put away was brought back, or was none of this one's */
  #hasResumed = false;
  /** the run that is being brought back */
  #load: RunLoad | null = null;

  /** Begins to follow the run. */
  constructor(ports: RunKeeperPorts) {
    this.#ports = ports;
    ports.simulator.listen((message) => {
      if (message.type === "frame") this.#follow(message.frame);
      if (message.type === "forgotten") this.#forgetAfter(message.after);
    });
  }

  /** Puts the run away for a reload; at once, since the page may be going. */
  flush(): void {
    const { tab } = this.#ports;
    const frame = this.#frame;
    // A page that goes so soon leaves what it has not brought back yet to the next one.
    if (!this.#hasResumed && this.#isUntouched()) return;
    tab.removeItem(RUN_KEY);
    if (frame === null || frame.nowTick === 0 || this.#asked === null) return;
    const { revision, ticks, text } = this.#asked;
    const until = revision === frame.revision ? frame.nowTick : ticks;
    try {
      if (text === null) tab.setItem(RUN_KEY, LOST);
      else tab.setItem(RUN_KEY, [until, this.#work(), text].join("\n"));
    } catch {
      this.#flushLoss();
    }
  }

  /**
   * Brings back the run that was put away, unless something else is open now or the robot drives
   * already.
   */
  async resume(): Promise<void> {
    try {
      await this.#bringBack();
    } finally {
      this.#hasResumed = true;
    }
  }

  async #bringBack(): Promise<void> {
    const { tab, simulator, loadReader, onLost } = this.#ports;
    const kept = tab.getItem(RUN_KEY);
    if (kept === null) return;
    const [until, work, text] = kept.split("\n");
    if (until === LOST) return onLost();
    if (work !== this.#work() || text === undefined) return;
    // Without its reader it is as lost as one that cannot be read.
    const readRun = await loadReader().catch(() => null);
    const run = readRun?.(text) ?? null;
    if (run === null) return onLost();
    if (!this.#isUntouched() || work !== this.#work()) return;
    this.#load = loadRun(simulator, run, { until: Number(until) });
    const loaded = await this.#load.loaded;
    this.#load = null;
    if (loaded.ok) this.#bringEdits(loaded);
    else if (loaded.reason !== "cancelled") onLost();
  }

  /** Whether nothing has happened to the robot that the page began with. */
  #isUntouched(): boolean {
    return (this.#frame?.nowTick ?? 0) === 0 && (this.#frame?.revision ?? 0) === 0;
  }

  /** Edits of the last moment before the reload, which the worker had not told yet. */
  #bringEdits(loaded: Pick<RunDocument, "maze" | "program">): void {
    const { workspace, simulator } = this.#ports;
    const { maze, program } = workspace.getState();
    if (JSON.stringify(loaded.maze) !== JSON.stringify(maze)) {
      simulator.send({ type: "edit-maze", maze });
    }
    if (JSON.stringify(loaded.program) !== JSON.stringify(program)) {
      simulator.send({ type: "edit-program", program });
    }
  }

  /** A run of which a part is forgotten is not the one to come back to; the new one is asked for at once. */
  #forgetAfter(tick: number): void {
    if (this.#asked === null || this.#asked.ticks <= tick) return;
    this.#asked = null;
    this.#isWaiting = false;
  }

  #follow(frame: Frame): void {
    this.#frame = frame;
    // Whoever drives or edits already while a long run is brought back has begun another one.
    if (!this.#isUntouched()) this.#load?.cancel();
    if (this.#isWaiting || this.#asked?.revision === frame.revision) return;
    this.#isWaiting = true;
    this.#endAsking();
    this.#endAsking = saveRun(this.#ports.simulator, (saved) => {
      const revision = this.#frame?.revision ?? 0;
      if (saved.ok) this.#asked = { revision, ticks: saved.ticks, text: saved.text };
      else this.#asked = { revision, ticks: 0, text: null };
    });
    const length = this.#asked?.text?.length ?? 0;
    this.#ports.later(
      () => {
        this.#isWaiting = false;
        if (this.#frame !== null) this.#follow(this.#frame);
      },
      ASK_EVERY_MS + length / CHARACTERS_PER_MS,
    );
  }

  /** The documents that are open, as one line. */
  #work(): string {
    const { maze, program } = this.#ports.workspace.getState();
    return JSON.stringify([maze, program]);
  }

  #flushLoss(): void {
    try {
      this.#ports.tab.setItem(RUN_KEY, LOST);
    } catch {
      // No word of it either in a tab that may store nothing at all.
    }
  }
}
