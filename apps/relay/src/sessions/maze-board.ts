/**
 * The maze that a robot is in, as its page gives it: kept with the session, since snapshots say where the robot
 * is but not among which walls. Whoever may look on can read it, and is told when there is another one.
 */
import type { MazeDocument } from "@corridor/maze";
import type { Clock } from "../clock.ts";
import { hashKey } from "../keys.ts";
import { noRobot, Refusal, retryAfter } from "../problems.ts";
import type { SessionStore } from "../store/session-store.ts";
import { limits } from "./limits.ts";
import { TokenBucket } from "./token-bucket.ts";

/** Characters of its hash by which a maze is told from the one before it. */
const VERSION_LENGTH = 22;

export interface KeptMaze {
  /** the document as JSON */
  text: string;
  /** the same for the same maze, at every relay */
  version: string;
}

export interface MazeBoardParts {
  robot: string;
  store: Pick<SessionStore, "keepMaze" | "maze">;
  clock: Clock;
  /** tells the readers here that there is another maze */
  tell: (version: string) => void;
  /** is told when this relay has kept one */
  changed: (version: string) => void;
}

export class MazeBoard {
  readonly #parts: MazeBoardParts;
  readonly #bucket: TokenBucket;
  /** the newest that this relay knows of */
  #known: string | null = null;

  constructor(parts: MazeBoardParts) {
    this.#parts = parts;
    this.#bucket = new TokenBucket(limits.mazeRate, parts.clock.now());
  }

  /** The maze; null while the page has given none. */
  async read(): Promise<KeptMaze | null> {
    const text = await this.#parts.store.maze(this.#parts.robot);
    if (text === null) return null;
    const version = versionOf(text);
    this.#known = version;
    return { text, version };
  }

  /**
   * Keeps the maze in the place of the one before; the same one again is no news.
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
    // Read by a schema, its fields stand in one order: the same maze has the same text.
    const text = JSON.stringify(maze);
    const version = versionOf(text);
    if ((await this.read())?.version === version) return version;
    if (!(await this.#parts.store.keepMaze(this.#parts.robot, text))) throw noRobot();
    this.heard(version);
    this.#parts.changed(version);
    return version;
  }

  /** There is another maze, here or at another relay. */
  heard(version: string): void {
    this.#known = version;
    this.#parts.tell(version);
  }

  /** Another relay may have kept one, unheard. */
  async lookAgain(): Promise<void> {
    const before = this.#known;
    const kept = await this.read();
    if (kept !== null && kept.version !== before) this.heard(kept.version);
  }
}

function versionOf(text: string): string {
  return hashKey(text).slice(0, VERSION_LENGTH);
}
