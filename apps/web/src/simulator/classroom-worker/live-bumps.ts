/**
 * The bumps of a run that has not ended: tiles contain them before the record of the run arrives,
 * which has their exact places. Pure.
 */
import { CELL } from "@corridor/maze";
import type { ProgressRecord, Tile } from "@corridor/protocol";
import { taskOf, type PlacedBumps, type Work } from "./student-work.ts";

export interface LiveBumps {
  /** the oldest first */
  places: readonly PlacedBumps[];
  /** bumps of which a record arrived before their tile */
  early: number;
}

export const noLiveBumps: LiveBumps = { places: [], early: 0 };

/**
 * Adds the bumps since the previous tile, at the place of the robot.
 * @param work of which there are records
 */
export function withTileBumps(
  live: LiveBumps,
  before: Tile | null,
  tile: Tile | null,
  work: Pick<Work, "lesson" | "tasks">,
): LiveBumps {
  if (tile === null || tile.maze === null) return live;
  const isSame = before?.task === tile.task && before.maze === tile.maze;
  const isReset = isSame && tile.tick < before.tick;
  if (tile.bumps === 0) return isReset && live.early > 0 ? { ...live, early: 0 } : live;
  // The records may contain what happened before in another task, or before the dashboard opened.
  if (!isSame && taskOf(work, tile.task).runs > 0) return live;
  const known = isReset ? 0 : isSame ? before.bumps : liveCount(live, tile.task);
  const early = isReset ? 0 : live.early;
  const count = tile.bumps - known - early;
  if (tile.bumps <= known) return live;
  if (count <= 0) return { ...live, early: -count };
  const { task, maze, pose } = tile;
  const [column, row] = [Math.floor(pose[0] / CELL), Math.floor(pose[1] / CELL)];
  const place = { lesson: work.lesson, task, maze, column, row, count };
  return { places: [...live.places, place], early: 0 };
}

function liveCount({ places }: LiveBumps, task: number): number {
  return places.reduce((sum, each) => sum + (each.task === task ? each.count : 0), 0);
}

/** Removes the bumps that a record of a run contains. */
export function withoutRecorded(live: LiveBumps, { event }: ProgressRecord): LiveBumps {
  if (event.kind !== "run") return live;
  let left = event.bumps;
  if (live.places.length === 0) return left === 0 ? live : { ...live, early: left };
  const places = live.places.flatMap((place) => {
    if (place.task !== event.task) return [place];
    const recorded = Math.min(left, place.count);
    left -= recorded;
    return recorded === place.count ? [] : [{ ...place, count: place.count - recorded }];
  });
  return { places, early: left };
}
