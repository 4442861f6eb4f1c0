/** A contender's server as a process of its own, with a folder of its own that goes with it. */
import { spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";

export interface ServerProcess {
  pid: number;
  /** what the pattern found in the line that said that it is ready */
  ready: string;
  stop: () => Promise<void>;
}

export interface ServerStart {
  command: string;
  words: (folder: string) => string[];
  environment?: (folder: string) => Record<string, string>;
  /** finds the address in a line that it writes; its first group counts */
  ready: RegExp;
  /** where it writes that line; default: stdout */
  from?: "stdout" | "stderr";
}

/** Starts it and waits until it says that it is ready. */
export async function startServer(start: ServerStart): Promise<ServerProcess> {
  const { command, words, environment = () => ({}), ready, from = "stdout" } = start;
  const folder = mkdtempSync(join(tmpdir(), "corridor-bench-"));
  const child = spawn(command, words(folder), {
    env: { ...process.env, ...environment(folder) },
    stdio: [
      "ignore",
      from === "stdout" ? "pipe" : "inherit",
      from === "stderr" ? "pipe" : "inherit",
    ],
  });
  const output = child[from];
  if (output === null) throw new Error("a server without a voice");
  for await (const line of createInterface({ input: output })) {
    const found = ready.exec(line);
    if (found === null) continue;
    // What it goes on to say must not fill the pipe.
    output.resume();
    return { pid: child.pid ?? 0, ready: found[1] ?? "", stop: () => end(child, folder) };
  }
  throw new Error(`${command} ended before it was ready`);
}

async function end(child: ChildProcess, folder: string): Promise<void> {
  const ended = once(child, "exit");
  child.kill();
  await ended;
  rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
}
