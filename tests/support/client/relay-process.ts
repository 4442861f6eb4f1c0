import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { onTestFinished } from "vitest";
import { killRelay, startRelayChild } from "./relay-child.ts";

export interface RelayProcess {
  origin: string;
  /** Kills the relay, and restarts it with the same data and port. */
  killAndRestart(): Promise<void>;
}

/** Starts a relay process with an empty store; it stops with the test. */
export async function startRelayProcess(): Promise<RelayProcess> {
  const dataDir = mkdtempSync(join(tmpdir(), "corridor-"));
  let { child, port } = await startRelayChild(dataDir, 0);
  onTestFinished(async () => {
    await killRelay(child);
    rmSync(dataDir, { recursive: true, force: true });
  });
  return {
    origin: `http://127.0.0.1:${port}`,
    killAndRestart: async () => {
      await killRelay(child);
      ({ child, port } = await startRelayChild(dataDir, port));
    },
  };
}
