/** Which ready-made maze a maze is, if any: in a file of its own with all of them. */
import { mazePresets, type MazeDocument, type MazePresetId } from "@corridor/maze";

/** A maze counts as it was given: with a block taken out or the start moved it is another one. */
export function presetOf(maze: MazeDocument): MazePresetId | null {
  return mazePresets.find((each) => isSame(each.maze, maze))?.id ?? null;
}

/** Names may be in another language. */
function isSame(preset: MazeDocument, maze: MazeDocument): boolean {
  return (
    preset.blocks.join() === maze.blocks.join() &&
    preset.start.column === maze.start.column &&
    preset.start.row === maze.start.row &&
    JSON.stringify(preset.goals) === JSON.stringify(maze.goals)
  );
}
