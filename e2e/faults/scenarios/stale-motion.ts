/**
 * The network fails while a script publishes velocities: the robot stops, and old values do not
 * move it again.
 */
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { callRepeatedly, machineNow, sleep, waitUntil } from "../clock.ts";
import { FaultProxy } from "../net/fault-proxy.ts";
import type { Robot } from "../robots/robot.ts";
import type { Scenario } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";
import { FlushingScript } from "../scripts/flushing-script.ts";
import { RequestScript } from "../scripts/request-script.ts";
import type { Script } from "../scripts/script.ts";
import { ClientScript } from "../scripts/client-script.ts";

const PER_SECOND = 10;
const SHORT_TIMES = 4;
const LONG_TIMES = 30;
const TIMEOUT_MS = 20_000;
/** time by which all queued commands have arrived and started after an outage */
const AFTER_MS = 2_000;
/** values published this shortly before the recovery of the network are not old */
const NEW_MS = 250;

const timesOf = (isLong: boolean): number => (isLong ? LONG_TIMES : SHORT_TIMES);

/** one robot, its script, and the network of one of the two, which is cut */
interface Pair {
  name: string;
  robot: Robot;
  script: Script;
  net: FaultProxy;
}

interface Cut {
  pair: Pair;
  /** ms from the cut until the robot stopped for good */
  stopMs: number;
  backAt: number;
  /** commands that the robot started after the recovery, before any newer ones */
  started: number[];
}

export const staleMotion: Scenario = {
  title: "Stale motion",
  describe: (isLong) =>
    `The network is cut for 1 to 4 s while a client publishes ${PER_SECOND} velocities per second, ${timesOf(isLong)} times each. The clients are the library by WebSocket and by HTTPS, single requests, and a client that queues while disconnected. The last cuts are in the network of the page`,
  run: async (context) => {
    const random = new SeededRandom(context.seed);
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const testBed = new TestBed(context);
    const net = async (): Promise<FaultProxy> => {
      const proxy = await FaultProxy.start({ target: () => relay.port, random });
      context.onCleanup(() => proxy.close());
      return proxy;
    };
    const clients: {
      name: string;
      connect: (robot: Robot, origin: string) => Promise<Script> | Script;
    }[] = [
      {
        name: "library, WebSocket",
        connect: (robot, origin) => ClientScript.connect(robot, origin, "websocket"),
      },
      {
        name: "library, HTTPS",
        connect: (robot, origin) => ClientScript.connect(robot, origin, "https"),
      },
      { name: "single requests", connect: (robot, origin) => new RequestScript(robot, origin) },
      { name: "flushing client", connect: (robot, origin) => new FlushingScript(robot, origin) },
      {
        name: "network of the page",
        connect: (robot) => ClientScript.connect(robot, relay.url, "websocket"),
      },
    ];
    await testBed.register(relay.url, clients.length);
    const pages = await testBed.startPages();
    const pairs: Pair[] = [];
    for (const [n, { name, connect }] of clients.entries()) {
      const robot = testBed.robots[n];
      if (robot === undefined) continue;
      const proxy = await net();
      const isPageNetwork = n === clients.length - 1;
      testBed.open(robot, pages, isPageNetwork ? proxy.origin : relay.url, "websocket");
      await waitUntil(() => robot.isConnected, TIMEOUT_MS);
      const script = await connect(robot, proxy.origin);
      context.onCleanup(() => script.close());
      pairs.push({ name, robot, script, net: proxy });
    }
    const seen: Cut[] = [];
    const measure = async (pair: Pair): Promise<void> => {
      for (let n = 0; n < timesOf(context.isLong); n++) {
        seen.push(await cutWhilePublishing(pair, random));
      }
    };
    await Promise.all(pairs.map(measure));
    const compared = await testBed.compare(relay.url);
    const old = seen.map(({ pair: { name, robot, script }, backAt, started, stopMs }) => {
      const log = compared.logs.get(robot) ?? [];
      const posts = started.map((seq) => script.commands.postedAt(log[seq - 1]?.key ?? null) ?? 0);
      const applied = posts.filter((at) => at < backAt - NEW_MS).length;
      if (applied > 1 || stopMs > 600) {
        context.log(`${name}: stopped after ${Math.round(stopMs)} ms, ${applied} old values`);
      }
      return applied;
    });
    return [
      {
        label: "slowest stop after the cut",
        measured: Math.max(...seen.map(({ stopMs }) => stopMs)),
        bound: { atMost: 600 },
        unit: `ms, of ${seen.length}`,
      },
      {
        label: "most old values that moved a robot after a reconnect",
        measured: Math.max(...old),
        bound: { atMost: 1 },
        unit: "",
      },
      ...compared.goals(),
    ];
  },
};

async function cutWhilePublishing(pair: Pair, random: SeededRandom): Promise<Cut> {
  const { robot, script, net } = pair;
  // On the spot, so that no wall stops the robot.
  const publish = (): void => script.post({ action: "drive", left: 0.3, right: -0.3 });
  await callRepeatedly(PER_SECOND, 1_500, publish);
  const cutAt = machineNow();
  net.isUp = false;
  net.cut();
  const outageMs = random.between(1_000, 4_000);
  let lastMoveAt = cutAt;
  await callRepeatedly(PER_SECOND, outageMs, () => {
    publish();
    if (robot.isMoving) lastMoveAt = machineNow();
    else lastMoveAt = Math.max(lastMoveAt, robot.movedAt);
  });
  const backAt = machineNow();
  net.isUp = true;
  await sleep(AFTER_MS);
  await waitUntil(() => script.commands.unanswered === 0 && robot.isConnected, TIMEOUT_MS);
  await sleep(AFTER_MS / 2);
  const started = robot.starts.flatMap(({ seq, at }) => (at > backAt ? [seq] : []));
  return { pair, stopMs: lastMoveAt - cutAt, backAt, started };
}
