/** Loads, changes and commits robots. Keeps the robots that were used last. */
import type { Redis } from "./connection.ts";
import { mintId } from "../../keys.ts";
import { commitKeys } from "./redis-keys.ts";
import { RobotQueue, type Step } from "./robot-queue.ts";
import { Script } from "./script.ts";
import { counted, type Words } from "./words.ts";

/** Robots in memory. The first step of any other robot costs one more round trip. */
const MOST_ROBOTS = 2_048;

export class RobotCommits {
  readonly #script: Script;
  readonly #relay: string;
  /** by their last use */
  readonly #queues = new Map<string, RobotQueue>();
  readonly #writer = mintId();
  #commits = 0;

  constructor(redis: Redis, relay: string) {
    this.#script = new Script(redis, "commit.lua");
    this.#relay = relay;
  }

  async create(id: string, changes: Words[]): Promise<void> {
    const words = ["", this.#newVersion(), "", ...counted(changes)];
    await this.#script.call(commitKeys(id), words);
  }

  /** Runs a step after all earlier steps of this robot. */
  run<T, Read = never>(id: string, step: Step<T, Read>): Promise<T> {
    const known = this.#queues.get(id);
    const queue = known ?? new RobotQueue(id, this.#parts);
    if (known !== undefined) this.#queues.delete(id);
    this.#queues.set(id, queue);
    if (this.#queues.size > MOST_ROBOTS) this.#dropOldest();
    return queue.run(step);
  }

  /** Called after robots were deleted. */
  drop(ids: readonly string[]): void {
    for (const id of ids) if (this.#queues.get(id)?.isIdle === true) this.#queues.delete(id);
  }

  get #parts() {
    return { script: this.#script, relay: this.#relay, newVersion: () => this.#newVersion() };
  }

  #dropOldest(): void {
    for (const [id, queue] of this.#queues) {
      // A second queue must not overtake one that is under way.
      if (!queue.isIdle) continue;
      this.#queues.delete(id);
      return;
    }
  }

  /** No other commit has the same version, not even one that was refused. */
  #newVersion(): string {
    this.#commits += 1;
    return `${this.#writer}:${this.#commits}`;
  }
}
