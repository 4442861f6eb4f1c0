/**
 * The network delays what a script sends, or what it receives: from the first byte on, and later on
 * a fast network. No command starts late, no started command is reported as expired, and on a fast
 * network no command expires.
 */
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { sleep } from "../clock.ts";
import { FaultProxy, type Delay, type Direction } from "../net/fault-proxy.ts";
import { makeCertificate, TlsProxy, trust, type Certificate } from "../net/tls-proxy.ts";
import type { Robot } from "../robots/robot.ts";
import type { Scenario } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";
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
  { name: "1 s", min: 1_000, max: 1_000 },
  { name: "3 s", min: 3_000, max: 3_000 },
  { name: "jitter", min: 0, max: 1_500 },
];
/** the delay that is repeated over TLS */
const TLS_DELAY = "1 s";
const directions: readonly Direction[] = ["up", "down"];

interface Library {
  name: string;
  /** @param trusted certificate file; null: without TLS */
  connect(address: string, trusted: string | null): TimedScript | Promise<TimedScript>;
}

const libraries: readonly Library[] = [
  {
    name: "TypeScript by WebSocket",
    connect: (address) => typeScriptScript(address, TTL_MS, "websocket"),
  },
  { name: "TypeScript by HTTP", connect: (address) => typeScriptScript(address, TTL_MS, "https") },
  { name: "Python by HTTP", connect: (address, trusted) => pythonScript(address, TTL_MS, trusted) },
];

/** one script with its own network */
interface Case {
  name: string;
  library: Library;
  direction: Direction;
  delay: Delay;
  /** whether the script connects by https: and wss: */
  isSecure: boolean;
}

interface Observation extends Outcome {
  of: Case;
  robot: Robot;
  isDelayed: boolean;
}

export const oneWayDelay: Scenario = {
  title: "One-way delay",
  describe: (isLong) =>
    `Python and TypeScript scripts send ${timesOf(isLong)} turns (ttl ${TTL_MS} ms) in each of four phases: with a delay in one direction, without, with, without. The delay is 1 s, 3 s or up to 1.5 s, and applies from the first byte on. The scripts with 1 s are repeated over HTTPS and WSS`,
  run: async (context) => {
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const offered = libraries.filter(
      ({ name }) => !name.startsWith("Python") || hasProgram("python3"),
    );
    if (offered.length < libraries.length)
      context.log("Python is skipped: python3 is not installed");
    const certificate = makeCertificate(context.folder);
    if (certificate === null) context.log("TLS is skipped: openssl is not installed");
    else trust(certificate);
    const tlsProxies: TlsProxy[] = [];
    const plain = { delays, isSecure: false };
    const secure = { delays: delays.filter(({ name }) => name === TLS_DELAY), isSecure: true };
    const cases = [plain, ...(certificate === null ? [] : [secure])].flatMap((kind) =>
      offered.flatMap((library) =>
        directions.flatMap((direction) =>
          kind.delays.map(({ name, ...delay }) => ({
            name: `${library.name}${kind.isSecure ? " over TLS" : ""}, ${name} ${direction}`,
            library,
            direction,
            delay,
            isSecure: kind.isSecure,
          })),
        ),
      ),
    );
    const testBed = new TestBed(context);
    await testBed.register(relay.url, cases.length);
    const pages = await testBed.startPages();
    for (const robot of testBed.robots) testBed.open(robot, pages, relay.url, "websocket");
    await testBed.waitUntilConnected();
    const random = new SeededRandom(context.seed);

    /** The delayed network of one script. With a certificate, it delays encrypted bytes. */
    const openNetwork = async (trusted: Certificate | null) => {
      if (trusted === null) {
        const proxy = await FaultProxy.start({ target: () => relay.port, random });
        context.onCleanup(() => proxy.close());
        return { proxy, origin: proxy.origin };
      }
      const server = await TlsProxy.start(trusted, () => relay.port);
      context.onCleanup(() => server.close());
      tlsProxies.push(server);
      const proxy = await FaultProxy.start({ target: () => server.port, random });
      context.onCleanup(() => proxy.close());
      return { proxy, origin: proxy.origin.replace("http:", "https:") };
    };
    const run = async (of: Case, robot: Robot): Promise<Observation[]> => {
      const trusted = of.isSecure ? certificate : null;
      const { proxy, origin } = await openNetwork(trusted);
      const { id, driverKey } = robot.registration;
      const seen: Observation[] = [];
      const turns = async (script: TimedScript, isDelayed: boolean): Promise<void> => {
        for (let n = 0; n < timesOf(context.isLong); n++)
          seen.push({ ...(await script.turn()), of, robot, isDelayed });
      };
      proxy.delays[of.direction] = of.delay;
      const address = `${origin}/r/${id}#${driverKey}`;
      const script = await of.library.connect(address, trusted?.file ?? null);
      context.onCleanup(() => script.close());
      for (let phase = 0; phase < 2; phase++) {
        proxy.delays[of.direction] = of.delay;
        await turns(script, true);
        proxy.clearFaults();
        // Data in transit is still delayed.
        await sleep(of.delay.max + 500);
        await turns(script, false);
      }
      return seen;
    };
    const seen = (
      await Promise.all(
        cases.map(async (of, n) => {
          const robot = testBed.robots[n];
          if (robot === undefined) throw new Error("a script has no robot");
          return run(of, robot);
        }),
      )
    ).flat();
    const compared = await testBed.compare(relay.url);

    const wrong = (label: string, isWrong: (each: Observation) => boolean, among = seen) => {
      const found = among.filter(isWrong);
      for (const { of, state, seq } of found.slice(0, 5))
        context.log(`${label}: ${of.name}, command ${seq ?? "without a number"}, ${state}`);
      return {
        label,
        measured: found.length,
        bound: { atMost: 0 },
        unit: `of ${among.length}`,
      };
    };
    const delayedUp = seen.filter(
      ({ of, isDelayed }) => isDelayed && of.direction === "up" && of.delay.min > TTL_MS,
    );
    const overTls = seen.filter(({ of }) => of.isSecure);
    const started = new Set(
      seen.flatMap(({ robot, seq }) => (seq === null ? [] : [`${robot.page} ${seq}`])),
    );
    const unknown = testBed.robots.flatMap(({ page, starts }) =>
      starts.filter(({ seq }) => !started.has(`${page} ${seq}`)),
    );
    return [
      wrong(`started later than ttl + ${TOLERANCE_MS} ms`, isLate),
      wrong("delayed for longer than ttl and not reported as expired", isNotExpired, delayedUp),
      {
        label: "started and reported as expired",
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
      {
        label: "scripts over HTTPS and WSS without a TLS connection",
        measured: tlsProxies.filter(({ connections }) => connections === 0).length,
        bound: { atMost: 0 },
        unit: `of ${tlsProxies.length}`,
      },
      wrong(`over HTTPS and WSS, started later than ttl + ${TOLERANCE_MS} ms`, isLate, overTls),
      ...compared.goals(["lost", "doubled", "ended twice"]),
    ];
  },
};

function isNotExpired({ state }: Observation): boolean {
  return state !== "expired";
}

function isLate({ robot, seq, postedAt }: Observation): boolean {
  const start = robot.starts.find((each) => each.seq === seq);
  return start !== undefined && start.at - postedAt > TTL_MS + TOLERANCE_MS;
}
