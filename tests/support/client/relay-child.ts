import { spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { join } from "node:path";

const MAIN = join(import.meta.dirname, "../../../apps/relay/src/main.ts");
const READY = /Corridor is ready: http:\/\/localhost:(\d+)/;

/**
 * Starts a relay process and waits until it listens.
 * @param port 0 for any free one
 */
export async function startRelayChild(
  dataDir: string,
  port: number,
  environment: Record<string, string> = {},
) {
  const child = spawn(process.execPath, [MAIN], {
    env: { PORT: String(port), HOST: "127.0.0.1", DATA_DIR: dataDir, ...environment },
    stdio: ["ignore", "pipe", "inherit"],
  });
  let text = "";
  for await (const data of child.stdout) {
    text += String(data);
    const ready = READY.exec(text);
    if (ready !== null) return { child, port: Number(ready[1]) };
  }
  throw new Error(`The relay did not start: ${text}`);
}

/** Kills the process without a clean shutdown. */
export async function killRelay(child: ChildProcess): Promise<void> {
  if (child.exitCode !== null || child.signalCode !== null) return;
  child.kill("SIGKILL");
  await once(child, "exit");
}
