/**
 * This tab's stored world: the run, and the endings of commands in it, which a reload restores. The
 * repository loads once there is something to store or to restore.
 */
import type { RestoreRun } from "../protocol/worker-messages.ts";
import type { RestoredJournal, RestorePorts } from "./restored-world.ts";
import type { RunLoop } from "./run-loop.ts";
import type { WorldRepository } from "./world-repository.ts";
import type { WorldJournal } from "./world-store.ts";

export interface StoredWorldPorts {
  /** @throws before the documents have arrived */
  run: () => RunLoop;
  /** endings of commands of the robot at the relay; null without one */
  journal: () => WorldJournal | null;
  /** another page has claimed the world, see `WorldRepositoryPorts` */
  onClaimed: () => void;
  /** lets the tab store the key of the world, or that there is none; answered by `keyNoted` */
  sendKey: (key: string | null) => void;
  /** monotonic milliseconds */
  now: () => number;
}

export class StoredWorld {
  readonly #ports: StoredWorldPorts;
  /** A failure is final: the page has reported that a reload restores nothing. */
  #loading: Promise<WorldRepository> | null = null;
  #repository: WorldRepository | null = null;
  #restored: RestoredJournal | null = null;
  /** waiting for the answers of the page, in order */
  readonly #keyNotes: ((isNoted: boolean) => void)[] = [];

  constructor(ports: StoredWorldPorts) {
    this.#ports = ports;
  }

  /** Endings of commands in the world before a reload; null if none was restored. */
  get restored(): RestoredJournal | null {
    return this.#restored;
  }

  /** Whether the tab could store the key. */
  keyNoted(isNoted: boolean): void {
    this.#keyNotes.shift()?.(isNoted);
  }

  /**
   * Stores progress if it is due.
   * @param hasChanged whether the run has changed since the last call
   */
  update(hasChanged: boolean): void {
    if (this.#repository !== null) return this.#repository.update();
    if (hasChanged && !this.#ports.run().isUntouched) void this.#load().catch(() => undefined);
  }

  /** Stores the world before an ending is sent. */
  async save(): Promise<void> {
    const repository = await this.#load().catch(() => null);
    await repository?.save();
  }

  /** Restores the run from before the reload. The caller calls `claimed` with the answer. */
  async restore(
    message: RestoreRun,
    { load, answer }: Pick<RestorePorts, "load" | "answer">,
  ): Promise<void> {
    const [repository, { restoreWorld }] = await Promise.all([
      this.#load(),
      import("./restored-world.ts"),
    ]);
    await restoreWorld(message, {
      repository,
      run: this.#ports.run(),
      load,
      answer,
      restored: (journal) => (this.#restored = journal),
    });
  }

  /** The claimed world is the live run now, or was discarded. */
  claimed(): void {
    this.#repository?.claimed();
  }

  #load(): Promise<WorldRepository> {
    this.#loading ??= this.#open();
    return this.#loading;
  }

  async #open(): Promise<WorldRepository> {
    try {
      const { openWorldRepository } = await import("./open-world-repository.ts");
      const { run, journal, onClaimed, now } = this.#ports;
      this.#repository = openWorldRepository({
        recording: () => run().recording,
        startedAt: () => run().startedAt,
        journal: () => journal() ?? this.#restored,
        storeKey: (key) => this.#storeKey(key),
        onClaimed,
        now,
      });
      return this.#repository;
    } catch (error) {
      // The file did not load: a reload restores nothing.
      await this.#storeKey(null);
      throw error;
    }
  }

  #storeKey(key: string | null): Promise<boolean> {
    this.#ports.sendKey(key);
    return new Promise((resolve) => this.#keyNotes.push(resolve));
  }
}
