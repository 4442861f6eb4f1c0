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
 * Drawing a maze takes a core that the trials need too. Until the end, only each fourth update
 * draws pictures.
 */
const SHOWN_PER_PICTURES = 4;
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
  readonly #later: (show: () => void) => void;
  /** results that are not displayed yet */
  #pending: TrialResult[] = [];
  #isDue = false;
  #shown = 0;

  /**
   * @param later runs a function after a delay; results between the first and the last are
   *   displayed together
   */
  constructor(pool: WorkerPool, later: (show: () => void) => void) {
    this.pool = pool;
    this.#later = later;
  }

  start({ kind, side, first }: TrialChoice, program: ProgramDocument): void {
    this.#pending = [];
    this.#shown = 0;
    this.store.setState({ state: "running", ...nothing });
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

  #showSoon(): void {
    const { results } = this.store.getState();
    const isFirstOrLast = results.size === 0 || results.size + this.#pending.length === TRIALS;
    if (isFirstOrLast) return this.#show();
    if (this.#isDue) return;
    this.#isDue = true;
    this.#later(() => {
      this.#isDue = false;
      this.#show();
    });
  }

  #show(): void {
    const pending = this.#pending.splice(0);
    if (pending.length === 0) return;
    const results = new Map(this.store.getState().results);
    for (const result of pending) results.set(result.seed, result);
    this.#shown++;
    if (results.size === TRIALS) this.store.setState({ state: "done", results, pictured: results });
    else if (this.#shown % SHOWN_PER_PICTURES > 0) this.store.setState({ results });
    else this.store.setState({ results, pictured: results });
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
