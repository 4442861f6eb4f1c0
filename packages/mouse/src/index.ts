export type { MarkColor } from "./mark-colors.ts";
export type { CellMark, MarkMessage } from "./marks.ts";
export { MouseSession, type MouseSessionOptions } from "./mouse-session.ts";
export type { Timers } from "./timers.ts";
