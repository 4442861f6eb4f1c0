/** The trials of the open program: which mazes, the progress, and the outcome of each. */
import type { ProgramDocument } from "@corridor/program";
import { createStore, type StoreApi } from "zustand/vanilla";
import type {
  TrialMazes,
  TrialOutcome,
  TrialResult,
} from "../../simulator/protocol/trial-messages.ts";
import type { WorkerPool } from "../../simulator/worker-pool.ts";

/** Mazes of one set. */
export const TRIALS = 100;
export const LEAST_TRIAL_SIDE = 5;
export const MOST_TRIAL_SIDE = 33;
/** The first seed of the last set: every seed of the set can be typed elsewhere. */
export const MOST_FIRST_SEED = 999_999_900;

export interface TrialChoice extends TrialMazes {
  /** seed of the first maze; the others follow */
  first: number;
}

/** The choice outlives the dialog, so that a corrected program is tried in the same mazes. */
export const trialChoice = createStore<TrialChoice>()(() => ({ kind: "tree", side: 11, first: 1 }));

export interface TrialsState {
  state: "idle" | "running" | "done" | "stopped" | "failed";
  /** by seed */
  results: ReadonlyMap<number, TrialResult>;
  /** results whose pictures are drawn */
  pictured: ReadonlyMap<number, TrialResult>;
}

/**
 * Delay in ms of the first results. Many programs have all of theirs by then, so that the grid is
 * rendered once.
 */
const FIRST_MS = 100;
/**
 * Interval in ms between two updates of the results. Each update lays out the grid, on a core that
 * the trials need too.
 */
const SHOW_MS = 200;
/** As updates, pictures take a core. Until the end, only each second update draws them. */
const SHOWN_PER_PICTURES = 2;
const nothing = {
  results: new Map<number, TrialResult>(),
  pictured: new Map<number, TrialResult>(),
};

export class Trials {
  readonly store: StoreApi<TrialsState> = createStore<TrialsState>()(() => ({
    state: "idle",
    ...nothing,
  }));
  readonly pool: WorkerPool;
  readonly #later: (show: () => void, milliseconds: number) => void;
  /** results that are not displayed yet */
  #pending: TrialResult[] = [];
  /** whether results are displayed after a delay */
  #isWaiting = false;
  #shown = 0;

  /**
   * @param later runs a function after a delay; results between the first and the last are
   *   displayed together
   */
  constructor(pool: WorkerPool, later: (show: () => void, milliseconds: number) => void) {
    this.pool = pool;
    this.#later = later;
  }

  start({ kind, side, first }: TrialChoice, program: ProgramDocument): void {
    this.#pending = [];
    this.#shown = 0;
    this.store.setState({ state: "running", ...nothing });
    this.#wait(FIRST_MS);
    this.pool.run({ kind: "trial", program, mazes: { kind, side }, first }, TRIALS, {
      onResult: (result) => {
        if (result.kind !== "trial") return;
        this.#pending.push(result.trial);
        this.#showSoon();
      },
      onEnd: (reason) => {
        if (reason === "failed") this.store.setState({ state: "failed" });
      },
    });
  }

  stop(): void {
    this.pool.stop();
    this.#show();
    const { state, results } = this.store.getState();
    if (state === "running") this.store.setState({ state: "stopped", pictured: results });
  }

  /** Stops, and deletes the results. */
  clear(): void {
    this.stop();
    this.store.setState({ state: "idle", ...nothing });
  }

  /** Stops, and terminates the workers. */
  close(): void {
    this.stop();
    this.pool.close();
  }

  #wait(milliseconds: number): void {
    if (this.#isWaiting) return;
    this.#isWaiting = true;
    this.#later(() => {
      this.#isWaiting = false;
      this.#show();
    }, milliseconds);
  }

  #showSoon(): void {
    const isLast = this.store.getState().results.size + this.#pending.length === TRIALS;
    if (isLast || !this.#isWaiting) this.#show();
  }

  #show(): void {
    const pending = this.#pending.splice(0);
    if (pending.length === 0) return;
    const results = new Map(this.store.getState().results);
    for (const result of pending) results.set(result.seed, result);
    this.#shown++;
    if (results.size === TRIALS) {
      this.store.setState({ state: "done", results, pictured: results });
      return;
    }
    if (this.#shown % SHOWN_PER_PICTURES > 0) this.store.setState({ results });
    else this.store.setState({ results, pictured: results });
    this.#wait(SHOW_MS);
  }
}

export function seedsFrom(first: number): number[] {
  return Array.from({ length: TRIALS }, (_, at) => first + at);
}

/** Counts the mazes by outcome. */
export function countOutcomes(
  results: ReadonlyMap<number, TrialResult>,
): Record<TrialOutcome, number> {
  const counts = { works: 0, bump: 0, "time-limit": 0 };
  for (const { outcome } of results.values()) counts[outcome]++;
  return counts;
}
