/**
 * The robot's maze, as its page publishes it. The relay stores it, because snapshots contain the
 * pose but not the blocks. Readers can request it and are notified of changes.
 */
import type { MazeDocument } from "@corridor/maze";
import type { PublishedMaze } from "@corridor/protocol";
import type { Clock } from "../platform/time/clock.ts";
import { hashKey } from "../platform/keys.ts";
import { noRobot, Refusal, retryAfter } from "../platform/errors/problems.ts";
import type { RobotStore } from "../store/robot-store.ts";
import { limits } from "../platform/limits/limits.ts";
import type { RobotChannel } from "./channel/robot-channel.ts";
import type { Subscribers } from "./readers/subscribers.ts";
import { TokenBucket } from "../platform/limits/token-bucket.ts";

/** Length of a version, which is the start of the maze's hash. */
const VERSION_LENGTH = 22;

export interface MazeBoardParts {
  robot: string;
  store: Pick<RobotStore, "storeMaze" | "maze">;
  clock: Clock;
  subscribers: Pick<Subscribers, "publishMaze">;
  channel: Pick<RobotChannel, "mazeChanged">;
}

export class MazeBoard {
  readonly #parts: MazeBoardParts;
  readonly #bucket: TokenBucket;
  /** newest version that this relay has seen */
  #known: string | null = null;

  constructor(parts: MazeBoardParts) {
    this.#parts = parts;
    this.#bucket = new TokenBucket(limits.mazeRate, parts.clock.now());
  }

  /** The maze; null until the page has published one. */
  async read(): Promise<PublishedMaze | null> {
    const text = await this.#parts.store.maze(this.#parts.robot);
    if (text === null) return null;
    const version = versionOf(text);
    this.#known = version;
    return { text, version };
  }

  /**
   * Stores the maze in place of the previous one. An unchanged maze is not published.
   * @returns its version
   * @throws Refusal too-fast or no-robot
   */
  async keep(maze: MazeDocument): Promise<string> {
    const waitMs = this.#bucket.take(this.#parts.clock.now());
    if (waitMs > 0) {
      throw new Refusal(
        "too-fast",
        `Too many mazes: a robot can publish one a second, with bursts of ${limits.mazeRate.burst}. Wait a second, then send the newest maze.`,
        {
          headers: retryAfter(waitMs),
        },
      );
    }
    // The schema orders the fields, so equal mazes have equal text.
    const text = JSON.stringify(maze);
    const version = versionOf(text);
    if ((await this.read())?.version === version) return version;
    if (!(await this.#parts.store.storeMaze(this.#parts.robot, text))) throw noRobot();
    this.received(version);
    this.#parts.channel.mazeChanged(version);
    return version;
  }

  /** Handles a new maze, stored here or at another relay. */
  received(version: string): void {
    this.#known = version;
    this.#parts.subscribers.publishMaze(version);
  }

  /** Reads the maze again, because a message of another relay may have been missed. */
  async reload(): Promise<void> {
    const before = this.#known;
    const stored = await this.read();
    if (stored !== null && stored.version !== before) this.received(stored.version);
  }
}

function versionOf(text: string): string {
  return hashKey(text).slice(0, VERSION_LENGTH);
}

/** Error response if the relay has no maze of the robot. */
export function noMaze(): Refusal {
  return new Refusal(
    "no-maze",
    "The robot's page has not published a maze, or the maze is too large. Try again once the page is connected.",
  );
}
