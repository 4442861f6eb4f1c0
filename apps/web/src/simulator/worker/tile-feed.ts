/**
 * The tiles of a student in a class: what the robot and the student do now, and where the robot
 * drove. Sent on change, and rarely.
 */
import { TILE_INTERVAL_MS, WATCHED_TILE_INTERVAL_MS, type Tile } from "@corridor/protocol";
import type { PositionLog, Run } from "@corridor/recording";
import type { ClassPlace } from "../protocol/class-messages.ts";
import { cellPath } from "./cell-path.ts";

/** Newest corners of the trail that a path can contain. */
const MAX_CORNERS = 400;
/** Positions and headings are sent in tenths. */
const PRECISION = 10;

/** The part of the live run that tiles show. */
export interface TileRun {
  readonly isRunning: boolean;
  readonly recording: {
    readonly run: Run;
    readonly corners: Pick<PositionLog, "countUpTo" | "slice">;
  };
}

interface TileFeedPorts {
  run: () => TileRun;
  /** milliseconds since 1970 */
  now: () => number;
}

type Shown = Omit<Tile, "seq">;

export class TileFeed {
  readonly #ports: TileFeedPorts;
  /** null before the student has opened the lesson */
  #task: number | null = null;
  /** null: the student works on something else */
  #place: ClassPlace | null = null;
  #hasChanged = false;
  #sentAt = Number.NEGATIVE_INFINITY;
  /** as sent last; empty: send the next one in any case */
  #sent = "";
  #seq = 0;

  constructor(ports: TileFeedPorts) {
    this.#ports = ports;
  }

  place(place: ClassPlace | null): void {
    this.#place = place;
    this.#task = place?.task ?? this.#task;
    this.#hasChanged = true;
  }

  /** The run has changed. */
  changed(): void {
    this.#hasChanged = true;
  }

  /** The next tile is sent even if an equal one was sent before. */
  restart(): void {
    this.#sent = "";
    this.#hasChanged = true;
  }

  /**
   * The tile to send now; null if none is due.
   * @param isWatched whether a teacher watches the student
   */
  take(isWatched: boolean): Tile | null {
    if (!this.#hasChanged || this.#task === null) return null;
    const now = this.#ports.now();
    const interval = isWatched ? WATCHED_TILE_INTERVAL_MS : TILE_INTERVAL_MS;
    // A clock that was set back must not stop the tiles.
    if (now >= this.#sentAt && now < this.#sentAt + interval) return null;
    this.#hasChanged = false;
    const shown =
      this.#place === null ? elsewhere(this.#task) : tileOf(this.#place, this.#ports.run());
    const text = JSON.stringify(shown);
    if (text === this.#sent) return null;
    this.#sent = text;
    this.#sentAt = now;
    return { seq: ++this.#seq, ...shown };
  }
}

/** The student has left the lesson: nothing of the other work is sent. */
function elsewhere(task: number): Shown {
  const still = { pose: [0, 0, 0], path: "", line: null, tick: 0, bumps: 0, passes: null } as const;
  return { ...still, task, maze: null, state: "writing", pose: [...still.pose] };
}

function tileOf(place: ClassPlace, { recording, isRunning }: TileRun): Shown {
  const { task, maze, passes } = place;
  const { run, corners } = recording;
  const { x, y, heading } = run.pose;
  const count = corners.countUpTo(run.tick);
  const places = corners.slice(Math.max(0, count - MAX_CORNERS), count);
  return {
    task,
    maze,
    state: stateOf(run, isRunning, place),
    pose: [rounded(x), rounded(y), rounded(heading) % 360],
    path: cellPath([...places, run.x, run.y]),
    line: run.line,
    tick: run.tick,
    bumps: run.bumps,
    passes,
  };
}

function stateOf(run: Run, isRunning: boolean, { isSolved, isDriven }: ClassPlace): Tile["state"] {
  if (isSolved) return "solved";
  if (isRunning) return "driving";
  // After an edit, no line has driven the last tick.
  const isEdited = run.driver === "program" && run.drivenBy === null;
  if (run.isStopped && run.bumps > 0 && !isEdited) return "bumped";
  return isDriven ? "driving" : "writing";
}

function rounded(value: number): number {
  return Math.round(value * PRECISION) / PRECISION;
}
