/**
 * Stores the world continuously: at most every quarter of a second, and before an ending of a
 * script's command is sent. A reload restores the run only from this world.
 *
 * Requests during a write wait for the next one together: many endings a second are few writes.
 */
import type { Recording, RunCheckpoint } from "@corridor/recording";
import type { StoredWorld, WorldJournal, WorldStore } from "./world-store.ts";

/** Interval for storing progress without an ending. */
const PROGRESS_MS = 250;
/** A store that does not respond for this long counts as unavailable. */
const TIMEOUT_MS = 5_000;

export interface WorldRepositoryPorts {
  openStore: () => Promise<WorldStore>;
  /** the live run */
  recording: () => Recording;
  /** when the live run began, in ms since 1970 */
  startedAt: () => number;
  /** endings of commands in it */
  journal: () => WorldJournal | null;
  /**
   * Lets the tab store the key of the world for a reload, or that there is none.
   * @returns whether the tab has stored it
   */
  storeKey: (key: string | null) => Promise<boolean>;
  /**
   * Another page has claimed the world of this run: later messages of this page would contradict
   * that page.
   */
  onClaimed: () => void;
  newId: () => string;
  /** monotonic milliseconds */
  now: () => number;
  /** calls back after so many milliseconds; the returned function cancels */
  after: (milliseconds: number, call: () => void) => () => void;
}

export class WorldRepository {
  readonly #ports: WorldRepositoryPorts;
  readonly #writer: string;
  #store: Promise<WorldStore> | null = null;
  /** key of the stored world; null before there is one */
  #key: string | null = null;
  #isClaiming = false;
  /** the stored state */
  #stored: { recording: Recording; revision: number; mark: RunCheckpoint; ticks: number } | null =
    null;
  /** the run that cannot be stored */
  #refused: Recording | null = null;
  #isWriting = false;
  /** for requests that wait for the next write */
  #next: { promise: Promise<void>; resolve: () => void } | null = null;
  #wroteAt = Number.NEGATIVE_INFINITY;

  constructor(ports: WorldRepositoryPorts) {
    this.#ports = ports;
    this.#writer = ports.newId();
  }

  /**
   * Stores the world as it is at the end of this event-loop turn. Resolves once it is stored, or
   * once a reload is certain to restore nothing, and after `onClaimed` if another page has claimed
   * this world.
   */
  save(): Promise<void> {
    if (this.#refused === this.#ports.recording()) return Promise.resolve();
    this.#next ??= Promise.withResolvers<void>();
    const { promise } = this.#next;
    this.#start();
    return promise;
  }

  /** Stores the progress of the run if there is any and the interval has passed. */
  update(): void {
    const { now, recording } = this.#ports;
    if (this.#isWriting || this.#isClaiming || now() - this.#wroteAt < PROGRESS_MS) return;
    if (this.#refused === recording() || !this.#hasChanged()) return;
    this.#start();
  }

  /**
   * Claims this tab's world from before a reload. Nothing is written before `claimed` is called: if
   * this page closes earlier, the next one can claim the world.
   * @returns null without a world
   */
  async claim(key: string): Promise<StoredWorld | null> {
    this.#isClaiming = true;
    const store = await this.#within(this.#opened());
    const world = await this.#within(store.claim(key, this.#writer));
    if (world !== null) this.#key = key;
    return world;
  }

  /** The claimed world is the live run now, or was discarded. */
  claimed(): void {
    this.#isClaiming = false;
  }

  #hasChanged(): boolean {
    const recording = this.#ports.recording();
    const { revision, run } = recording;
    const stored = this.#stored;
    if (this.#key === null && run.tick === 0 && revision === 0) return false;
    return (
      stored?.recording !== recording || stored.revision !== revision || stored.ticks !== run.tick
    );
  }

  #start(): void {
    if (this.#isWriting) return;
    this.#isWriting = true;
    this.#wroteAt = this.#ports.now();
    // Changes in the same turn belong to the same world.
    void Promise.resolve().then(() => this.#write());
  }

  async #write(): Promise<void> {
    const waiting = this.#next;
    this.#next = null;
    try {
      await this.#writeNow(waiting !== null);
    } catch {
      await this.#refuse();
    }
    waiting?.resolve();
    this.#isWriting = false;
    if (this.#next !== null) this.#start();
  }

  async #writeNow(isStrict: boolean): Promise<void> {
    const { storeKey, onClaimed, newId, recording, startedAt, journal } = this.#ports;
    const store = await this.#within(this.#opened());
    if (this.#key === null) {
      const key = newId();
      // On a first visit over a slow network, the page may load long after its robot has started.
      if (!(await storeKey(key))) throw new Error("the tab cannot note the key");
      this.#key = key;
    }
    const run = recording();
    const { revision } = run;
    const mark = this.#stored?.recording === run ? this.#stored.mark : null;
    const update = run.updateSince(mark);
    if (update === null) throw new Error("the run is longer than a document may be");
    const entry = { update, startedAt: startedAt(), journal: journal(), isStrict };
    const outcome = await this.#within(store.write(this.#key, this.#writer, entry));
    this.#stored = null;
    if (outcome === "gone") return this.#writeNow(isStrict);
    if (outcome === "claimed") {
      this.#key = null;
      return onClaimed();
    }
    this.#stored = { recording: run, revision, mark: update.checkpoint, ticks: update.ticks };
  }

  /** Stops storing this run: the page reports it, and a reload restores nothing. */
  async #refuse(): Promise<void> {
    this.#refused = this.#ports.recording();
    this.#key = null;
    this.#stored = null;
    this.#store = null;
    await this.#ports.storeKey(null);
  }

  #opened(): Promise<WorldStore> {
    this.#store ??= this.#ports.openStore();
    return this.#store;
  }

  /** Rejects after a timeout. */
  async #within<Result>(work: Promise<Result>): Promise<Result> {
    let cancel = (): void => undefined;
    const late = new Promise<never>((_resolve, reject) => {
      cancel = this.#ports.after(TIMEOUT_MS, () => reject(new Error("the store is unavailable")));
    });
    try {
      return await Promise.race([work, late]);
    } finally {
      cancel();
    }
  }
}
