/** The real relay, in a process of its own, that can be killed and started again on the same port. */
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { onTestFinished } from "vitest";
import { killRelay, startRelayChild } from "./relay-child.ts";

export interface RelayProcess {
  origin: string;
  /** Ends it as a power cut would, and starts it again with the same data. */
  killAndRestart(): Promise<void>;
}

/** Starts a relay with an empty store; it is ended with the test. */
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
