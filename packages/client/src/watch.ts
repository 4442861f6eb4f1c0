/** Entry "@corridor/client/watch": for the page of viewers. */
export { WatchConnection, type WatchStatus } from "./watch-connection.ts";
