/** Starts robot hosts with `robot_server.py`. */
import { spawn, type ChildProcess } from "node:child_process";
import type { Socket } from "node:net";
import { join } from "node:path";
import { createInterface } from "node:readline";

interface Started {
  id: number;
  pid: number;
  address?: string;
  error?: string;
}

let server: ChildProcess | null = null;
let newestId = 0;
const pending = new Map<number, (started: Started) => void>();

/** The process ends with this one, which closes its input. */
function robotServer(): ChildProcess {
  if (server !== null) return server;
  // -S: the example needs no packages, and starts faster without them.
  const started = spawn("python3", ["-S", join(import.meta.dirname, "robot_server.py")], {
    stdio: ["pipe", "pipe", "inherit"],
    env: { ...process.env, PYTHONDONTWRITEBYTECODE: "1" },
  });
  createInterface({ input: started.stdout }).on("line", (line) => {
    const host = JSON.parse(line) as Started;
    pending.get(host.id)?.(host);
    pending.delete(host.id);
  });
  const fail = (reason: string) => {
    server = null;
    for (const [id, settle] of pending) settle({ id, pid: 0, error: reason });
    pending.clear();
  };
  started.on("error", (error) => fail(error.message));
  started.on("exit", (code) => fail(`the server has ended with ${code}`));
  // The server does not prevent the end of this process.
  started.unref();
  for (const stream of [started.stdin, started.stdout]) (stream as Socket).unref();
  server = started;
  return started;
}

/**
 * Starts a host.
 * @param path of robot_host.py
 * @throws Error if the host ends without an address
 */
export async function startHost(path: string, args: readonly string[]) {
  const id = ++newestId;
  const { stdin } = robotServer();
  const host = await new Promise<Started>((resolve) => {
    pending.set(id, resolve);
    stdin?.write(`${JSON.stringify([id, path, ...args])}\n`);
  });
  if (host.address === undefined) throw new Error(`The robot's host has ended: ${host.error}`);
  return { address: host.address, stop: () => process.kill(host.pid, "SIGKILL") };
}
