/**
 * Scripts that use the client libraries and return, for each command, its request time and reported
 * outcome.
 */
import { spawn, type ChildProcess } from "node:child_process";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";
import { ClientError, RobotClient } from "@corridor/client";
import { inPath } from "../../../scripts/programs.ts";
import { machineNow } from "../clock.ts";
import { platformFor } from "../platforms.ts";
import type { Transports } from "../robots/page-messages.ts";

const library = fileURLToPath(new URL("../../../packages/client-python/src", import.meta.url));

/** one command from its script's point of view */
export interface Outcome {
  /** by `machineNow` */
  postedAt: number;
  /** number of the command, or null if the library reported none */
  seq: number | null;
  /** state of the record, or code of the error */
  state: string;
}

export interface TimedScript {
  /** Turns by a few degrees and waits for the outcome. */
  turn(): Promise<Outcome>;
  close(): void;
}

/**
 * Makes a turn for each line of input and prints a line of JSON for each turn. Its clock is
 * `machineNow`.
 */
const PYTHON = `
import json, sys, time
from corridor import Robot, RobotError
robot = Robot(sys.argv[1], ttl=float(sys.argv[2]))
for line in sys.stdin:
    posted = time.monotonic() * 1000
    try:
        command = robot.turn(3)
        outcome = {"seq": command.seq, "state": command.state}
    except RobotError as error:
        outcome = {"seq": None, "state": error.code}
    print(json.dumps({"postedAt": posted, **outcome}), flush=True)
`;

class PythonScript implements TimedScript {
  readonly #process: ChildProcess;
  readonly #outcomes: AsyncIterator<string>;

  constructor(address: string, ttl: number, trusted: string | null) {
    const python = inPath("python3")[0] ?? "python3";
    const script = spawn(python, ["-c", PYTHON, address, String(ttl / 1000)], {
      stdio: ["pipe", "pipe", "inherit"],
      env: {
        ...process.env,
        PYTHONPATH: library,
        ...(trusted !== null && { SSL_CERT_FILE: trusted }),
      },
    });
    this.#process = script;
    this.#outcomes = createInterface({ input: script.stdout })[Symbol.asyncIterator]();
  }

  async turn(): Promise<Outcome> {
    this.#process.stdin?.write("\n");
    const line = await this.#outcomes.next();
    if (line.done === true) throw new Error("The Python script has ended.");
    return JSON.parse(line.value) as Outcome;
  }

  close(): void {
    this.#process.kill("SIGKILL");
  }
}

/**
 * @param ttl in ms
 * @param trusted file of the certificate that the script trusts in place of the usual ones
 */
export function pythonScript(
  address: string,
  ttl: number,
  trusted: string | null = null,
): TimedScript {
  return new PythonScript(address, ttl, trusted);
}

/** @param ttl in ms */
export async function typeScriptScript(
  address: string,
  ttl: number,
  transports: Transports,
): Promise<TimedScript> {
  const client = await RobotClient.connect(address, { ttl, platform: platformFor(transports) });
  return {
    turn: async () => {
      const postedAt = machineNow();
      return client.turn(3).then(
        ({ seq, state }) => ({ postedAt, seq, state }),
        (error: unknown) => {
          if (error instanceof ClientError) return { postedAt, seq: null, state: error.code };
          throw error;
        },
      );
    },
    close: () => client.close(),
  };
}
