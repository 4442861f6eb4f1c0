/**
 * Finds the preset that a maze is. This module is a separate chunk, because it contains all
 * presets.
 */
import { mazePresets, type MazeDocument, type MazePresetId } from "@corridor/maze";

/**
 * Compares whole mazes: with a block removed or the start moved, a maze is no longer the preset.
 */
export function presetOf(maze: MazeDocument): MazePresetId | null {
  return mazePresets.find((each) => isSame(each.maze, maze))?.id ?? null;
}

/** Ignores names, which may be in another language. */
function isSame(preset: MazeDocument, maze: MazeDocument): boolean {
  return (
    preset.blocks.join() === maze.blocks.join() &&
    preset.start.column === maze.start.column &&
    preset.start.row === maze.start.row &&
    JSON.stringify(preset.goals) === JSON.stringify(maze.goals)
  );
}
