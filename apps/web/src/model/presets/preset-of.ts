/**
 * Finds the preset that a maze is. This module is a separate chunk, because it contains all
 * presets.
 */
import { isSameLayout, mazePresets, type MazeDocument, type MazePresetId } from "@corridor/maze";

/**
 * Compares whole mazes: with a block removed or the start moved, a maze is no longer the preset.
 */
export function presetOf(maze: MazeDocument): MazePresetId | null {
  return mazePresets.find((each) => isSame(each.maze, maze))?.id ?? null;
}

/** Ignores names, which may be in another language, and the direction of the robot at the start. */
function isSame(preset: MazeDocument, maze: MazeDocument): boolean {
  const { heading } = preset.start;
  return isSameLayout(preset, { ...maze, start: { ...maze.start, heading } });
}
