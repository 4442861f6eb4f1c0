export { CommandLog, type TimelineCommand } from "./command-log.ts";
export { openRun, Replay } from "./open-run.ts";
export type { PositionLog } from "./position-log.ts";
export type { Playback } from "./playback.ts";
export { Recording, type RunCheckpoint, type RunUpdate, type WrittenRun } from "./recording.ts";
export { type RunDocument } from "./run-document.ts";
export { type RunInput, type TimedInput } from "./run-input.ts";
export { MAX_RUN_INPUTS, MAX_RUN_NAME_LENGTH, MAX_RUN_TEXT_LENGTH } from "./run-limits.ts";
export { parseRun, readRun } from "./run-schema.ts";
export { Run } from "./run.ts";
export {
  Timeline,
  turnNames,
  type TimelineEvent,
  type TimelineDelta,
  type TurnName,
  type TimelineDriver,
} from "./timeline.ts";
