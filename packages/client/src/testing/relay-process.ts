/** The real relay, in a process of its own, that can be killed and started again on the same port. */
import { spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { onTestFinished } from "vitest";

const MAIN = join(import.meta.dirname, "../../../../apps/relay/src/main.ts");
const READY = /Corridor is ready: http:\/\/localhost:(\d+)/;

export interface RelayProcess {
  origin: string;
  /** Ends it as a power cut would, and starts it again with the same data. */
  killAndRestart(): Promise<void>;
}

/** Starts a relay with an empty store; it is ended with the test. */
export async function startRelayProcess(): Promise<RelayProcess> {
  const dataDir = mkdtempSync(join(tmpdir(), "corridor-"));
  let { child, port } = await start(dataDir, 0);
  onTestFinished(async () => {
    await kill(child);
    rmSync(dataDir, { recursive: true, force: true });
  });
  return {
    origin: `http://127.0.0.1:${port}`,
    killAndRestart: async () => {
      await kill(child);
      ({ child, port } = await start(dataDir, port));
    },
  };
}

async function start(dataDir: string, port: number) {
  const child = spawn(process.execPath, [MAIN], {
    env: { PORT: String(port), HOST: "127.0.0.1", DATA_DIR: dataDir },
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

async function kill(child: ChildProcess): Promise<void> {
  if (child.exitCode !== null || child.signalCode !== null) return;
  child.kill("SIGKILL");
  await once(child, "exit");
}
