export { dailyMaze, dayAfter, dayNumber, type Day } from "./daily.ts";
export { isBinaryMaze } from "./contest/cell-bytes.ts";
export {
  checkContest,
  contestRules,
  type BrokenRule,
  type ContestCheck,
  type ContestRule,
  type WallFollowerMiss,
} from "./contest/check-contest.ts";
export {
  contestMazeOf,
  type ContestMaze,
  type ContestRefusal,
  type ContestRefusalCode,
} from "./contest/contest-maze.ts";
export { isContestText, readBinaryMaze } from "./contest/read-contest-maze.ts";
export {
  contestFormats,
  writeContestMaze,
  type ContestFormat,
} from "./contest/write-contest-maze.ts";
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
  toggleGoal,
  type MazeEdit,
  type MazeRefusal,
} from "./maze-edit.ts";
export { mazePresets, type MazePreset, type MazePresetId } from "./presets.ts";
export { createRandom, type Random } from "./random.ts";
export { readTextMaze, writeTextMaze } from "./text-maze.ts";
