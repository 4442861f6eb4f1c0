/**
 * A process of pages: each is a robot. It ends with the process that started it, or by `kill -9`,
 * which is how a tab goes that is closed or reloaded in the midst of whatever it does.
 */
import type { FromPages, ToPages } from "./page-messages.ts";
import { RobotPage } from "./robot-page.ts";

/** As the worker does it. */
const INTERVAL_MS = 8;

const pages = new Map<number, RobotPage>();
const tell = (message: FromPages): void => void process.send?.(message);

process.on("message", (message: ToPages) => {
  if (message.do === "open") {
    pages.set(message.page, new RobotPage(message, tell));
    return;
  }
  pages.get(message.page)?.leave();
  pages.delete(message.page);
});
process.on("disconnect", () => process.exit());
setInterval(() => {
  for (const page of pages.values()) page.turn();
}, INTERVAL_MS);
tell({ tells: "ready" });
