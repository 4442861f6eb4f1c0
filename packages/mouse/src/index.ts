export { MouseSession, type MouseSessionOptions } from "./mouse-session.ts";
export type { Timers } from "./timers.ts";
