/** Entry "@corridor/client/watch": for a page that shows a robot to those who look on. */
export { WatchLink, type WatchStatus } from "./watch-link.ts";
