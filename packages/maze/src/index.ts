export { CELL, gridOf, type Grid } from "./grid.ts";
export { countOpenCells, distancesFromStart, isReachable, UNREACHABLE } from "./flood-fill.ts";
export { generateTree, type TreeOptions } from "./generate.ts";
export {
  BLOCK,
  headingNames,
  isBlock,
  MAX_GOALS,
  MAX_NAME_LENGTH,
  MAX_SIDE,
  OPEN,
  parseMaze,
  readMaze,
  sizeOf,
  type Cell,
  type HeadingName,
  type MazeDocument,
  type Start,
} from "./maze-document.ts";
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
