/** The relay as a separate process, as `npm start` runs it. */
import { spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { join } from "node:path";
import { onTestFinished } from "vitest";
import { testFolder } from "../../../apps/relay/src/testing/test-relay.ts";

const MAIN = join(import.meta.dirname, "../../../apps/relay/src/main.ts");

export interface RelayProcess {
  child: ChildProcess;
  /** all output so far */
  output(): string;
  /** Waits until the output matches. @throws Error if the process exits before */
  says(pattern: RegExp): Promise<RegExpExecArray>;
  /** Waits for the exit. @returns the exit code */
  ended(): Promise<number | null>;
}

/** Starts the relay. The test ends it. */
export function startRelayProcess(
  environment: Record<string, string>,
  options: string[] = [],
): RelayProcess {
  const child = spawn(process.execPath, [MAIN, ...options], {
    env: { PATH: process.env["PATH"] ?? "", PORT: "0", DATA_DIR: testFolder(), ...environment },
    stdio: ["ignore", "pipe", "pipe"],
  });
  let text = "";
  child.stdout.on("data", (data: Buffer) => (text += data.toString()));
  child.stderr.on("data", (data: Buffer) => (text += data.toString()));
  const end = once(child, "close") as Promise<[number | null]>;
  onTestFinished(async () => {
    child.kill("SIGKILL");
    await end;
  });
  return {
    child,
    output: () => text,
    says: async (pattern) => {
      for (;;) {
        const match = pattern.exec(text);
        if (match !== null) return match;
        if (child.exitCode !== null) throw new Error(`The relay ended: ${text}`);
        await Promise.race([once(child.stdout, "data"), once(child.stderr, "data"), end]);
      }
    },
    ended: async () => (await end)[0],
  };
}
