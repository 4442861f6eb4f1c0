/**
 * A process of pages, each of which is a robot. It exits with its parent, or is killed with `kill
 * -9`, like a tab that is closed or reloaded in the middle of its work.
 */
import type { FromPages, ToPages } from "./page-messages.ts";
import { RobotPage } from "./robot-page.ts";

/** interval of the worker */
const INTERVAL_MS = 8;

const pages = new Map<number, RobotPage>();
const report = (message: FromPages): void => void process.send?.(message);

process.on("message", (message: ToPages) => {
  if (message.type === "open") {
    pages.set(message.page, new RobotPage(message, report));
    return;
  }
  pages.get(message.page)?.close();
  pages.delete(message.page);
});
process.on("disconnect", () => process.exit());
setInterval(() => {
  for (const page of pages.values()) page.advance();
}, INTERVAL_MS);
report({ type: "ready" });
