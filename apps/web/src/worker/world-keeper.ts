/**
 * Stores the world as it goes on: at most every quarter of a second, and before an ending of a script's command is
 * sent. What is stored is the one place from which a reload restores the run.
 *
 * While a write is under way, what asks for the next one waits for it together: many endings a second are few writes.
 */
import type { Recording, RunCheckpoint } from "@corridor/recording";
import type { StoredWorld, WorldJournal, WorldStore } from "./world-store.ts";

/** Progress without an ending is stored this often. */
const PROGRESS_MS = 250;
/** A store that does not answer for so long counts as one that cannot store. */
const PATIENCE_MS = 5_000;

export interface WorldKeeperPorts {
  openStore: () => Promise<WorldStore>;
  /** the live run */
  recording: () => Recording;
  /** how commands have ended in it */
  journal: () => WorldJournal | null;
  /** Has the tab note where a reload finds the world, or that it finds none. @returns whether it has */
  noteKey: (key: string | null) => Promise<boolean>;
  /** Another page has claimed the world of this run: what this page sends of it from now on contradicts that page. */
  onClaimed: () => void;
  newId: () => string;
  /** monotonic milliseconds */
  now: () => number;
  /** calls back after so many milliseconds, unless it is cancelled by what this returns */
  after: (milliseconds: number, call: () => void) => () => void;
}

export class WorldKeeper {
  readonly #ports: WorldKeeperPorts;
  readonly #writer: string;
  #store: Promise<WorldStore> | null = null;
  /** of the stored world; null before there is one */
  #key: string | null = null;
  #isClaiming = false;
  /** what is stored */
  #stored: { recording: Recording; revision: number; mark: RunCheckpoint; ticks: number } | null =
    null;
  /** the run that cannot be stored */
  #refused: Recording | null = null;
  #isWriting = false;
  /** for those who wait for the next write */
  #next: { promise: Promise<void>; resolve: () => void } | null = null;
  #wroteAt = Number.NEGATIVE_INFINITY;

  constructor(ports: WorldKeeperPorts) {
    this.#ports = ports;
    this.#writer = ports.newId();
  }

  /**
   * Stores the world as it is at the end of this turn, so that it survives whatever happens.
   * Resolves once it is stored, or once a reload is sure to restore nothing, and after `onClaimed` where another
   * page has claimed this world.
   */
  save(): Promise<void> {
    if (this.#refused === this.#ports.recording()) return Promise.resolve();
    this.#next ??= Promise.withResolvers<void>();
    const { promise } = this.#next;
    this.#start();
    return promise;
  }

  /** Stores the progress of the run, where there is some and it is time. */
  follow(): void {
    const { now, recording } = this.#ports;
    if (this.#isWriting || this.#isClaiming || now() - this.#wroteAt < PROGRESS_MS) return;
    if (this.#refused === recording() || !this.#hasNews()) return;
    this.#start();
  }

  /**
   * Takes over the world that this tab had before a reload. Nothing is written before `claimed` is called: a page
   * that goes earlier leaves it to the next one.
   * @returns null where there is none
   */
  async claim(key: string): Promise<StoredWorld | null> {
    this.#isClaiming = true;
    const store = await this.#within(this.#opened());
    const world = await this.#within(store.claim(key, this.#writer));
    if (world !== null) this.#key = key;
    return world;
  }

  /** The claimed world is the live run now, or is given up. */
  claimed(): void {
    this.#isClaiming = false;
  }

  #hasNews(): boolean {
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
    // What happens in the same turn belongs to the same world.
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
    const { noteKey, onClaimed, newId, recording, journal } = this.#ports;
    const store = await this.#within(this.#opened());
    if (this.#key === null) {
      const key = newId();
      // On a first visit over a slow network, the page may come long after its robot.
      if (!(await noteKey(key))) throw new Error("the tab cannot note the key");
      this.#key = key;
    }
    const run = recording();
    const { revision } = run;
    const mark = this.#stored?.recording === run ? this.#stored.mark : null;
    const update = run.updateSince(mark);
    if (update === null) throw new Error("the run is longer than a document may be");
    const entry = { update, journal: journal(), isStrict };
    const outcome = await this.#within(store.write(this.#key, this.#writer, entry));
    this.#stored = null;
    if (outcome === "gone") return this.#writeNow(isStrict);
    if (outcome === "claimed") {
      this.#key = null;
      return onClaimed();
    }
    this.#stored = { recording: run, revision, mark: update.checkpoint, ticks: update.ticks };
  }

  /** This run is not stored any more: the page says so, and after a reload there is none to restore. */
  async #refuse(): Promise<void> {
    this.#refused = this.#ports.recording();
    this.#key = null;
    this.#stored = null;
    this.#store = null;
    await this.#ports.noteKey(null);
  }

  #opened(): Promise<WorldStore> {
    this.#store ??= this.#ports.openStore();
    return this.#store;
  }

  /** What takes too long fails. */
  async #within<Result>(work: Promise<Result>): Promise<Result> {
    let cancel = (): void => undefined;
    const late = new Promise<never>((_resolve, reject) => {
      cancel = this.#ports.after(PATIENCE_MS, () => reject(new Error("the store does not answer")));
    });
    try {
      return await Promise.race([work, late]);
    } finally {
      cancel();
    }
  }
}
