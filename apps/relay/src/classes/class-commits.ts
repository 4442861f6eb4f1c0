/**
 * The only owner of the state of one class at this relay. Steps that wait for the store are decided
 * in order and committed together, so that 200 students can join at once. If another relay has
 * changed the class, the steps are decided again on its newest state.
 */
import { randomInt } from "node:crypto";
import { limits } from "../platform/limits/limits.ts";
import type { Clock } from "../platform/time/clock.ts";
import { mintClassCode } from "../platform/keys.ts";
import { noClass } from "../platform/errors/problems.ts";
import type { ClassChanges, ClassStore } from "../store/class-store.ts";
import type { ClassCommit } from "../bus/class-bus.ts";
import type { ClassRecord } from "../bus/class-record.ts";
import { applied, stateOf, type ClassState } from "./class-state.ts";
import { mergedChanges, unchanged, type Step, type StepContext } from "./step.ts";

export interface CommitListener {
  /** Publishes a commit of this relay, unless the store has done so. */
  committed(commit: ClassCommit): void;
  /**
   * The state is newer than `before`, by a commit of this relay or of another.
   * @param events null: some may be missing
   */
  changed(before: ClassState, events: readonly ClassRecord[] | null): void;
  /** The class does not exist any more. */
  ended(): void;
}

interface Waiting {
  /** @returns how to answer the caller after the commit */
  decide(state: ClassState, context: StepContext): Decision;
  fail(error: unknown): void;
}

interface Decision {
  changes: ClassChanges | null;
  events: readonly ClassRecord[];
  readonly answer: () => void;
}

export class ClassCommits {
  readonly #id: string;
  readonly #store: ClassStore;
  readonly #clock: Clock;
  readonly #listener: CommitListener;
  #state: ClassState;
  #waiting: Waiting[] = [];
  /** commits of other relays that arrived during a commit of this one */
  #received: ClassCommit[] = [];
  #mustReload = false;
  #isBusy = false;
  #willRetry = false;

  constructor(
    id: string,
    state: ClassState,
    parts: { store: ClassStore; clock: Clock; listener: CommitListener },
  ) {
    this.#id = id;
    this.#state = state;
    this.#store = parts.store;
    this.#clock = parts.clock;
    this.#listener = parts.listener;
  }

  /** the newest state that is stored */
  get state(): ClassState {
    return this.#state;
  }

  /**
   * Runs a step. Its changes are stored when the promise resolves.
   * @throws Refusal of the step, or no-class; the error of the store
   */
  run<T>(step: Step<T>): Promise<T> {
    const { promise, resolve, reject } = Promise.withResolvers<T>();
    this.#waiting.push({
      decide: (state, context) => {
        const { value, changes, events } = step(state, context);
        return { changes, events, answer: () => resolve(value) };
      },
      fail: reject,
    });
    this.#start();
    return promise;
  }

  /** Handles a commit of another relay. */
  received(commit: ClassCommit): void {
    this.#received.push(commit);
    this.#start();
  }

  /** Commits of other relays may have been missed. */
  missed(): void {
    this.#mustReload = true;
    this.#start();
  }

  /** Reads the class again. @returns its newest state */
  async reloaded(): Promise<ClassState> {
    this.missed();
    return this.run((state) => unchanged(state));
  }

  #start(): void {
    if (!this.#isBusy) void this.#drain();
  }

  async #drain(): Promise<void> {
    this.#isBusy = true;
    // Callers of one turn share a commit.
    await Promise.resolve();
    while (this.#waiting.length > 0 || this.#received.length > 0 || this.#mustReload) {
      const steps = this.#waiting.splice(0);
      try {
        if (this.#applyCommits() || this.#mustReload) await this.#reload();
        if (steps.length > 0) await this.#commit(steps);
      } catch (error) {
        // The store does not respond, and the commit may have taken effect.
        this.#mustReload = true;
        for (const each of steps) each.fail(error);
        if (this.#waiting.length === 0) break;
      }
    }
    this.#isBusy = false;
    if (this.#mustReload) this.#retryLater();
  }

  /** The store does not report that it responds again, and maybe no request follows. */
  #retryLater(): void {
    if (this.#willRetry) return;
    this.#willRetry = true;
    this.#clock.after(limits.storeRetryMs, () => {
      this.#willRetry = false;
      this.#start();
    });
  }

  async #commit(steps: readonly Waiting[]): Promise<void> {
    for (;;) {
      const before = this.#state;
      const { changes, events, answers } = this.#decide(steps);
      if (changes !== null) {
        const commit = commitOf(before, changes, events);
        const { version } = before.row;
        const text = JSON.stringify(commit);
        const result = await this.#store.commit(this.#id, version, changes, text);
        if (result === "no-class") return this.#end(steps);
        if (result === "conflict" && !(await this.#reload())) return this.#end(steps);
        if (result !== "committed") continue;
        this.#state = applied(before, changes);
        this.#listener.committed(commit);
        this.#listener.changed(before, events);
      }
      for (const answer of answers) answer();
      return;
    }
  }

  /** Decides all steps in order. A rejected step does not affect the others. */
  #decide(steps: readonly Waiting[]) {
    const now = this.#clock.now();
    const context = {
      now,
      mintCode: mintClassCode,
      random: (below: number) => (below > 1 ? randomInt(below) : 0),
    };
    let state = this.#state;
    let changes: ClassChanges | null = null;
    const events: ClassRecord[] = [];
    const answers: (() => void)[] = [];
    for (const each of steps) {
      try {
        const decision = each.decide(state, context);
        if (decision.changes !== null) {
          state = applied(state, decision.changes);
          changes = mergedChanges(changes, decision.changes);
        }
        events.push(...decision.events);
        answers.push(decision.answer);
      } catch (error) {
        answers.push(() => each.fail(error));
      }
    }
    return { changes, events, answers };
  }

  /** Applies commits of other relays in order. @returns whether some are missing */
  #applyCommits(): boolean {
    for (const { version, changes, events } of this.#received.splice(0)) {
      const before = this.#state;
      if (changes.row.version <= before.row.version) continue;
      if (version !== before.row.version) return true;
      this.#state = applied(before, changes);
      this.#listener.changed(before, events);
    }
    return false;
  }

  /** @returns false if the class does not exist any more */
  async #reload(): Promise<boolean> {
    this.#mustReload = false;
    const loaded = await this.#store.load(this.#id);
    if (loaded === null) {
      this.#listener.ended();
      return false;
    }
    const before = this.#state;
    this.#state = stateOf(loaded);
    this.#listener.changed(before, null);
    return true;
  }

  #end(steps: readonly Waiting[]): void {
    for (const each of steps) each.fail(noClass());
    this.#listener.ended();
  }
}

function commitOf(
  { row }: ClassState,
  { row: next, students, removed }: ClassChanges,
  events: readonly ClassRecord[],
): ClassCommit {
  return {
    kind: "changes",
    version: row.version,
    changes: { row: next, students: [...students], removed: [...removed] },
    events: [...events],
  };
}
