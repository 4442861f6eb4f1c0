/** Entry "@corridor/client/watch": for the page of viewers. */
export { WatchLink, type WatchStatus } from "./watch-connection.ts";
