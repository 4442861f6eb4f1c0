/**
 * The net of a script delays what it sends, or what it is sent: from the first byte on, and later
 * on a net that was quick. Nothing starts late, nothing that started is told as expired, and on a
 * quick net nothing expires.
 */
import { Dice } from "../../../apps/relay/src/testing/faults/dice.ts";
import { RelayProcess } from "../../support/relay-process.ts";
import { sleep } from "../clock.ts";
import { FaultProxy, type Delay, type Direction } from "../net/fault-proxy.ts";
import type { Robot } from "../robots/robot.ts";
import type { Row } from "../row.ts";
import { Scene } from "../scene.ts";
import { hasProgram } from "../scripts/example-script.ts";
import {
  pythonScript,
  typeScriptScript,
  type Outcome,
  type TimedScript,
} from "../scripts/timed-script.ts";

const TTL_MS = 400;
const TOLERANCE_MS = 100;
const timesOf = (isLong: boolean): number => (isLong ? 20 : 3);

const delays: readonly (Delay & { name: string })[] = [
  { name: "1 s", least: 1_000, most: 1_000 },
  { name: "3 s", least: 3_000, most: 3_000 },
  { name: "jitter", least: 0, most: 1_500 },
];
const directions: readonly Direction[] = ["up", "down"];

interface Library {
  name: string;
  connect(address: string): TimedScript | Promise<TimedScript>;
}

const libraries: readonly Library[] = [
  {
    name: "TypeScript by WebSocket",
    connect: (address) => typeScriptScript(address, TTL_MS, "websocket"),
  },
  { name: "TypeScript by HTTPS", connect: (address) => typeScriptScript(address, TTL_MS, "https") },
  { name: "Python by HTTPS", connect: (address) => pythonScript(address, TTL_MS) },
];

/** One script behind its own net. */
interface Case {
  name: string;
  library: Library;
  direction: Direction;
  delay: Delay;
}

interface Seen extends Outcome {
  of: Case;
  robot: Robot;
  isDelayed: boolean;
}

export const oneWayDelay: Row = {
  title: "One-way delay",
  does: (isLong) =>
    `Python and TypeScript scripts send ${timesOf(isLong)} turns (ttl ${TTL_MS} ms) in each phase: with 1 s, 3 s or up to 1.5 s of delay there or back from the first byte on, without, with, without`,
  run: async (terms) => {
    const relay = await RelayProcess.start();
    terms.after(() => relay.stop());
    const offered = libraries.filter(
      ({ name }) => !name.startsWith("Python") || hasProgram("python3"),
    );
    if (offered.length < libraries.length)
      terms.say("Python is left out: there is no python3 here");
    const cases = offered.flatMap((library) =>
      directions.flatMap((direction) =>
        delays.map(({ name, ...delay }) => ({
          name: `${library.name}, ${name} ${direction}`,
          library,
          direction,
          delay,
        })),
      ),
    );
    const scene = new Scene(terms);
    await scene.register(relay.url, cases.length);
    const pages = await scene.startPages();
    for (const robot of scene.robots) scene.open(robot, pages, relay.url, "websocket");
    await scene.allConnected();
    const dice = new Dice(terms.seed);

    const run = async (of: Case, robot: Robot): Promise<Seen[]> => {
      const proxy = await FaultProxy.start({ target: () => relay.port, dice });
      terms.after(() => proxy.close());
      const { id, driverKey } = robot.registration;
      const seen: Seen[] = [];
      const turns = async (script: TimedScript, isDelayed: boolean): Promise<void> => {
        for (let n = 0; n < timesOf(terms.isLong); n++)
          seen.push({ ...(await script.turn()), of, robot, isDelayed });
      };
      proxy.delays[of.direction] = of.delay;
      const script = await of.library.connect(`${proxy.origin}/r/${id}#${driverKey}`);
      terms.after(() => script.close());
      for (let phase = 0; phase < 2; phase++) {
        proxy.delays[of.direction] = of.delay;
        await turns(script, true);
        proxy.mend();
        // What is under way still takes its time.
        await sleep(of.delay.most + 500);
        await turns(script, false);
      }
      return seen;
    };
    const seen = (
      await Promise.all(
        cases.map(async (of, n) => {
          const robot = scene.robots[n];
          if (robot === undefined) throw new Error("a script has no robot");
          return run(of, robot);
        }),
      )
    ).flat();
    const compared = await scene.compare(relay.url);

    const wrong = (label: string, isWrong: (each: Seen) => boolean, among = seen) => {
      const found = among.filter(isWrong);
      for (const { of, state, seq } of found.slice(0, 5))
        terms.say(`${label}: ${of.name}, command ${seq ?? "without a number"}, ${state}`);
      return {
        label,
        measured: found.length,
        bound: { atMost: 0 },
        unit: `of ${among.length}`,
      };
    };
    const slowThere = seen.filter(
      ({ of, isDelayed }) => isDelayed && of.direction === "up" && of.delay.least > TTL_MS,
    );
    const started = new Set(
      seen.flatMap(({ robot, seq }) => (seq === null ? [] : [`${robot.page} ${seq}`])),
    );
    const unknown = scene.robots.flatMap(({ page, starts }) =>
      starts.filter(({ seq }) => !started.has(`${page} ${seq}`)),
    );
    return [
      wrong(`started later than ttl + ${TOLERANCE_MS} ms`, isLate),
      wrong("held up for longer than ttl and not told as expired", isNotExpired, slowThere),
      {
        label: "started and told as expired",
        measured: unknown.length,
        bound: { atMost: 0 },
        unit: `of ${seen.length}`,
      },
      wrong(
        "without delay not completed",
        ({ state }) => state !== "completed",
        seen.filter(({ isDelayed }) => !isDelayed),
      ),
      wrong(
        "neither completed nor expired",
        ({ state }) => state !== "completed" && state !== "expired",
      ),
      ...compared.goals(["lost", "doubled", "ended twice"]),
    ];
  },
};

function isNotExpired({ state }: Seen): boolean {
  return state !== "expired";
}

function isLate({ robot, seq, postedAt }: Seen): boolean {
  const start = robot.starts.find((each) => each.seq === seq);
  return start !== undefined && start.at - postedAt > TTL_MS + TOLERANCE_MS;
}
