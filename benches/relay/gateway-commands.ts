/**
 * Measures commands of other protocols relative to native ones: SOAP to REST, and a micromouse program
 * to a script. Each round has new robots, because a key may send a burst of 40 commands only.
 */
import { RobotClient } from "@corridor/client";
import { connectPort } from "@corridor/client/bridge";
import type { MazeDocument } from "@corridor/maze";
import type { Registration } from "@corridor/protocol";
import { clock } from "../../apps/cli/src/bridges/clock.ts";
import { envelopeXml, operationXml } from "../../apps/relay/src/testing/soap-client.ts";
import { MouseSession } from "../../packages/mouse/src/mouse-session.ts";
import { MazeHost } from "../../tests/support/client/maze-host.ts";
import type { Goal } from "../core/goals.ts";
import { median, timesSlower } from "../core/measure.ts";
import { printRow } from "./section.ts";

const WARM_UP = 3;
const ROUNDS = 7;
/** of a robot in a round */
const COMMANDS = 30;
/** cm between two cells of the maze */
const CELL = 200;

/** Two cells between walls. The robot drives from one to the other, and turns around. */
const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Two cells",
  blocks: ["###", "#.#", "#.#", "#.#", "###"],
  start: { column: 1, row: 3, heading: "north" },
  goals: [],
};
const steps = ["move", "left", "left"] as const;
const mouseLines = { move: "moveForward\n", left: "turnLeft\n" } as const;

/** One request after the other, whose command waits. @param origin of a relay */
export async function measureSoap(origin: string): Promise<Goal> {
  const post = async (url: string, headers: object, body: string): Promise<number> => {
    const startedAt = performance.now();
    const answer = await fetch(url, { method: "POST", headers: { ...headers }, body });
    await answer.text();
    if (!answer.ok) throw new Error(`${url} answers ${answer.status}`);
    return performance.now() - startedAt;
  };
  const [rest, soap] = await alternately(
    async () => {
      const { id, driverKey } = await register(origin);
      const url = `${origin}/api/v1/robots/${id}/commands`;
      const headers = { Authorization: `Bearer ${driverKey}`, "Content-Type": "application/json" };
      return times(() => post(url, headers, '{"action":"left 90"}'));
    },
    async () => {
      const { id, driverKey } = await register(origin);
      const robot = `${origin}/r/${id}#${driverKey}`;
      const message = envelopeXml(operationXml("Command", { robot, action: "left 90" }));
      const headers = { "Content-Type": "text/xml; charset=utf-8" };
      return times(() => post(`${origin}/soap`, headers, message));
    },
  );
  printRow("one command at a time", ["p50, us"]);
  printRow("POST commands", [median(rest) * 1000]);
  printRow("SOAP Command", [median(soap) * 1000]);
  return {
    label: "a command by SOAP, p50, relative to REST",
    measured: timesSlower(soap, rest),
    bound: { atMost: 1.5 },
    unit: "times",
  };
}

/** Each command after the end of the one before, with a robot that executes it at once. */
export async function measureMouse(origin: string): Promise<Goal> {
  const [script, mouse] = await alternately(
    async () =>
      withHost(origin, async (address) => {
        const client = await RobotClient.connect(address);
        const all = await times(async (step) => {
          const startedAt = performance.now();
          const { state } = await (step === "move" ? client.move(CELL) : client.left90());
          if (state !== "completed") throw new Error(`a command of the script is ${state}`);
          return performance.now() - startedAt;
        });
        client.close();
        return all;
      }),
    async () =>
      withHost(origin, async (address) => {
        let respond: (line: string) => void = () => undefined;
        const session = await MouseSession.start({
          port: await connectPort(address, {
            userAgent: "corridor-mms/0.1.0",
            warn: console.error,
          }),
          timers: clock,
          respond: (line) => respond(line),
          report: console.error,
          mark: () => undefined,
          onEnd: console.error,
        });
        const all = await times(async (step) => {
          const startedAt = performance.now();
          const response = await new Promise<string>((resolve) => {
            respond = resolve;
            void session.receive(mouseLines[step]);
          });
          if (response !== "ack") throw new Error(`a command of the program is ${response}`);
          return performance.now() - startedAt;
        });
        session.close();
        return all;
      }),
  );
  printRow("moves and turns", ["per second"]);
  printRow("script", [1000 / median(script)]);
  printRow("mms", [1000 / median(mouse)]);
  return {
    label: "moves of a micromouse program a second, relative to a script",
    measured: 1 / timesSlower(mouse, script),
    bound: { atLeast: 0.8 },
    unit: "times",
  };
}

/** Runs a request for each step. @returns the median of the ms that the requests return */
async function times(request: (step: (typeof steps)[number]) => Promise<number>): Promise<number> {
  const all: number[] = [];
  for (let n = 0; n < COMMANDS; n += 1) {
    all.push(await request(steps[n % steps.length] ?? "move"));
  }
  return median(all);
}

/** Runs both measurements in each round. @returns the results of each, without those of the warm-up */
async function alternately(
  native: () => Promise<number>,
  other: () => Promise<number>,
): Promise<[native: number[], other: number[]]> {
  const results: [number[], number[]] = [[], []];
  for (let round = -WARM_UP; round < ROUNDS; round += 1) {
    const one = await native();
    const two = await other();
    if (round < 0) continue;
    results[0].push(one);
    results[1].push(two);
  }
  return results;
}

async function register(origin: string): Promise<Registration> {
  const answer = await fetch(`${origin}/api/v1/robots`, { method: "POST" });
  return (await answer.json()) as Registration;
}

/** @param measure receives the address of a robot in the maze */
async function withHost(
  origin: string,
  measure: (address: string) => Promise<number>,
): Promise<number> {
  const registration = await register(origin);
  const host = new MazeHost(origin, registration, maze);
  try {
    await host.connected;
    await MazeHost.publish(origin, registration, maze);
    return await measure(`${origin}/r/${registration.id}#${registration.driverKey}`);
  } finally {
    host.connection.close();
  }
}
