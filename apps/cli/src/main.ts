#!/usr/bin/env node
/**
 * The command `corridor`. Its worker threads start from this file, too: in the installed package,
 * it is the only file with a known name.
 */
import module from "node:module";
import { isMainThread } from "node:worker_threads";

// Node.js stores compiled modules in the system's temporary folder. Without this cache, a short
// `grade` spends as long on loading its modules as on its runs. Each thread enables it for itself,
// and only for later imports. Node.js 20 has no compile cache.
if ("enableCompileCache" in module) module.enableCompileCache();
if (isMainThread) {
  const { runCommandLine } = await import("./command-line.ts");
  const { runProcess } = await import("./run-command.ts");
  await runProcess(() => runCommandLine(process.argv.slice(2), new URL(import.meta.url)));
} else {
  await import("./grade-worker.ts");
}
