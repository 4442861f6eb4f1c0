export { dailyMaze, dayAfter, dayNumber, type Day } from "./daily.ts";
export { CELL, gridOf, type Grid } from "./grid.ts";
export { isSameLayout, isSameMaze } from "./same-maze.ts";
export { countOpenCells, distancesFromStart, isReachable, UNREACHABLE } from "./flood-fill.ts";
export {
  generateMaze,
  generateTree,
  mazeKinds,
  type MazeKind,
  type TreeOptions,
} from "./generate.ts";
export { isBlock, sizeOf } from "./maze-cells.ts";
export {
  mazeSchema,
  parseMaze,
  readMaze,
  type Cell,
  type MazeDocument,
  type Start,
} from "./maze-document.ts";
export {
  BLOCK,
  headingNames,
  MAX_GOALS,
  MAX_NAME_LENGTH,
  MAX_SIDE,
  OPEN,
  type HeadingName,
} from "./maze-limits.ts";
export {
  clearBlocks,
  rename,
  resize,
  setBlock,
  setStart,
  toggleBlock,
  toggleGoal,
  type MazeEdit,
  type MazeRefusal,
} from "./maze-edit.ts";
export { mazePresets, type MazePreset, type MazePresetId } from "./presets.ts";
export { createRandom, type Random } from "./random.ts";
export { readTextMaze, writeTextMaze } from "./text-maze.ts";
