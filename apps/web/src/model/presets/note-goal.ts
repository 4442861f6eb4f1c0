/**
 * Stores what a goal changes on this device: the solved preset, and the best run in a daily maze.
 * Loaded during the first run, because the presets are not part of the first screen.
 */
import type { MazeDocument } from "@corridor/maze";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";
import { noteDaily, utcDay, type DailyBest } from "./daily-best.ts";
import { presetOf } from "./preset-of.ts";
import { readSolved, SOLVED_KEY, type SolvedStore } from "./solved-storage.ts";

/** @param maze in which the goal was reached */
export function noteGoal(
  device: KeyValueStorage,
  solved: SolvedStore,
  maze: MazeDocument,
  run: DailyBest,
): void {
  noteDaily(device, maze, run, utcDay(new Date()));
  const id = presetOf(maze);
  if (id === null || solved.getState().ids.includes(id)) return;
  // Another tab may have added an id since.
  const ids = [...new Set([...solved.getState().ids, ...readSolved(device), id])];
  solved.setState({ ids });
  try {
    device.setItem(SOLVED_KEY, JSON.stringify(ids));
  } catch {
    // The autosave reports a full or forbidden storage. The mark lasts as long as the page.
  }
}
