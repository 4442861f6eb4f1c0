/** Loads, changes and commits robots. Keeps the robots that were used last. */
import { z } from "zod";
import type { Redis } from "./connection.ts";
import { mintId } from "../../platform/keys.ts";
import { commitKeys } from "./redis-keys.ts";
import { RobotQueue, type Step } from "./robot-queue.ts";
import { Script } from "./script.ts";
import { counted, type Words } from "./words.ts";

const created = z.tuple([z.literal("done")]);

/** Robots in memory. The first step of any other robot costs one more round trip. */
const MOST_ROBOTS = 2_048;

export class RobotCommits {
  readonly #script: Script;
  readonly #relay: string;
  /** by their last use */
  readonly #queues = new Map<string, RobotQueue>();
  readonly #most: number;
  readonly #writer = mintId();
  #commits = 0;

  /** @param most robots to keep in memory */
  constructor(redis: Redis, relay: string, most = MOST_ROBOTS) {
    this.#most = most;
    this.#script = new Script(redis, ["commit.lua"]);
    this.#relay = relay;
  }

  async create(id: string, changes: Words[]): Promise<void> {
    const words = ["", this.#newVersion(), "", ...counted(changes)];
    const answer = await this.#script.call(commitKeys(id), words);
    if (!created.safeParse(answer).success) throw new Error("a robot with this id exists");
  }

  /** Runs a step after all earlier steps of this robot. */
  run<T, Read = never>(id: string, step: Step<T, Read>): Promise<T> {
    const known = this.#queues.get(id);
    const queue = known ?? new RobotQueue(id, this.#parts);
    if (known !== undefined) this.#queues.delete(id);
    this.#queues.set(id, queue);
    const result = queue.run(step);
    // Not before the step: an idle queue could be the one that runs it.
    if (this.#queues.size > this.#most) this.#dropOldest();
    return result;
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
