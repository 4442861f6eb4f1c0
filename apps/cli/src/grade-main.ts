/**
 * The command `grade` as one file, which a relay serves as `/grade.mjs`. Its worker threads start
 * from this file, too.
 */
import { isMainThread } from "node:worker_threads";

if (isMainThread) {
  const { command } = await import("./grade.ts");
  const { runCommand, runProcess } = await import("./run-command.ts");
  const help = command.help.replaceAll("corridor grade", "node grade.mjs");
  const args = process.argv.slice(2);
  await runProcess(() => runCommand({ ...command, help }, args, new URL(import.meta.url)));
} else {
  await import("./grade-worker.ts");
}
