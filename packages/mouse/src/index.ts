export { MouseSession, type MouseSessionOptions } from "./mouse-session.ts";
