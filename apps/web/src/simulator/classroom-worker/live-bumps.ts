/**
 * The bumps of a run that has not ended: tiles contain them before the record of the run arrives,
 * which has their exact places. Pure.
 */
import { CELL } from "@corridor/maze";
import type { ProgressRecord, Tile } from "@corridor/protocol";
import type { PlacedBumps } from "./student-work.ts";

export interface LiveBumps {
  /** the oldest first */
  places: readonly PlacedBumps[];
  /** bumps of which a record arrived before their tile */
  early: number;
}

export const noLiveBumps: LiveBumps = { places: [], early: 0 };

/** Adds the bumps since the previous tile, at the place of the robot. */
export function withTileBumps(
  live: LiveBumps,
  before: Tile | null,
  tile: Tile | null,
  lesson: string | null,
): LiveBumps {
  if (before === null || tile === null || tile.maze === null) return live;
  // What happened before in another maze is not known.
  if (before.task !== tile.task || before.maze !== tile.maze) return live;
  const isReset = tile.tick < before.tick;
  const count = tile.bumps - (isReset ? 0 : before.bumps);
  if (count <= 0) return isReset && live.early > 0 ? { ...live, early: 0 } : live;
  const early = isReset ? 0 : live.early;
  const left = count - early;
  if (left <= 0) return { ...live, early: -left };
  const { task, maze, pose } = tile;
  const [column, row] = [Math.floor(pose[0] / CELL), Math.floor(pose[1] / CELL)];
  const place = { lesson, task, maze, column, row, count: left };
  return { places: [...live.places, place], early: 0 };
}

/** Removes the bumps that a record of a run contains. */
export function withoutRecorded(live: LiveBumps, { event }: ProgressRecord): LiveBumps {
  if (event.kind !== "run") return live;
  let left = event.bumps;
  const places = live.places.flatMap((place) => {
    if (place.task !== event.task) return [place];
    const recorded = Math.min(left, place.count);
    left -= recorded;
    return recorded === place.count ? [] : [{ ...place, count: place.count - recorded }];
  });
  return { places, early: left };
}
