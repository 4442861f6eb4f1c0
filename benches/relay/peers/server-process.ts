/** Runs a peer's server as a process with a temporary folder, which is deleted when it stops. */
import { spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";

export interface ServerProcess {
  pid: number;
  /** first group of the pattern in the line that reports readiness */
  ready: string;
  stop: () => Promise<void>;
}

export interface ServerStart {
  command: string;
  args: (folder: string) => string[];
  environment?: (folder: string) => Record<string, string>;
  /** matches the line that reports readiness; its first group is the address */
  ready: RegExp;
  /** stream of that line; default: stdout */
  stream?: "stdout" | "stderr";
}

/** Starts a server and waits until it is ready. @throws Error if it ends before */
export async function startServer(start: ServerStart): Promise<ServerProcess> {
  const { command, args, environment = () => ({}), ready, stream = "stdout" } = start;
  const folder = mkdtempSync(join(tmpdir(), "corridor-bench-"));
  const child = spawn(command, args(folder), {
    env: { ...process.env, ...environment(folder) },
    stdio: [
      "ignore",
      stream === "stdout" ? "pipe" : "inherit",
      stream === "stderr" ? "pipe" : "inherit",
    ],
  });
  const output = child[stream];
  if (output === null) throw new Error(`${command} has no ${stream}`);
  for await (const line of createInterface({ input: output })) {
    const match = ready.exec(line);
    if (match === null) continue;
    // Later output is discarded, so that the pipe does not fill up.
    output.resume();
    return { pid: child.pid ?? 0, ready: match[1] ?? "", stop: () => stopProcess(child, folder) };
  }
  throw new Error(`${command} ended before it was ready`);
}

async function stopProcess(child: ChildProcess, folder: string): Promise<void> {
  const ended = once(child, "exit");
  child.kill();
  await ended;
  rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
}
