/**
 * The net goes while a script publishes velocities: the robot stops, and old values do not move it
 * again.
 */
import { Dice } from "../../../apps/relay/src/testing/faults/dice.ts";
import { RelayProcess } from "../../support/relay-process.ts";
import { everyFor, machineNow, sleep, until } from "../clock.ts";
import { FaultProxy } from "../net/fault-proxy.ts";
import type { Robot } from "../robots/robot.ts";
import type { Row } from "../row.ts";
import { Scene } from "../scene.ts";
import { FlushingScript } from "../scripts/flushing-script.ts";
import { RequestScript } from "../scripts/request-script.ts";
import type { Script } from "../scripts/script.ts";
import { SocketScript } from "../scripts/socket-script.ts";

const PER_SECOND = 10;
const SHORT_TIMES = 4;
const LONG_TIMES = 30;
const PATIENCE_MS = 20_000;
/** What was kept while the net was away has come, and has been begun, long before. */
const AFTER_MS = 2_000;
/** Published so shortly before the net was back a value is not old. */
const NEW_MS = 250;

const timesOf = (isLong: boolean): number => (isLong ? LONG_TIMES : SHORT_TIMES);

/** One robot, its script, and the net of either that is cut. */
interface Pair {
  name: string;
  robot: Robot;
  script: Script;
  net: FaultProxy;
}

interface Cut {
  pair: Pair;
  /** ms after the cut until the robot stood for good */
  stillMs: number;
  backAt: number;
  /** what the robot began after the net was back, before anything new was published */
  begun: number[];
}

export const staleMotion: Row = {
  title: "Stale motion",
  does: (isLong) =>
    `the net is cut for 1 to 4 s while velocities are published ${PER_SECOND} times a second, ${timesOf(isLong)} times for each of: the library by WebSocket and by HTTPS, single requests, a client that keeps what it cannot send and flushes it, the net of the page`,
  run: async (terms) => {
    const dice = new Dice(terms.seed);
    const relay = await RelayProcess.start();
    terms.after(() => relay.stop());
    const scene = new Scene(terms);
    const net = async (): Promise<FaultProxy> => {
      const proxy = await FaultProxy.start({ target: () => relay.port, dice });
      terms.after(() => proxy.close());
      return proxy;
    };
    const ways: {
      name: string;
      connect: (robot: Robot, origin: string) => Promise<Script> | Script;
    }[] = [
      {
        name: "library, WebSocket",
        connect: (robot, origin) => SocketScript.connect(robot, origin, "websocket"),
      },
      {
        name: "library, HTTPS",
        connect: (robot, origin) => SocketScript.connect(robot, origin, "https"),
      },
      { name: "single requests", connect: (robot, origin) => new RequestScript(robot, origin) },
      { name: "flushing client", connect: (robot, origin) => new FlushingScript(robot, origin) },
      {
        name: "net of the page",
        connect: (robot) => SocketScript.connect(robot, relay.url, "websocket"),
      },
    ];
    await scene.register(relay.url, ways.length);
    const pages = await scene.startPages();
    const pairs: Pair[] = [];
    for (const [n, { name, connect }] of ways.entries()) {
      const robot = scene.robots[n];
      if (robot === undefined) continue;
      const proxy = await net();
      const isOfPage = n === ways.length - 1;
      scene.open(robot, pages, isOfPage ? proxy.origin : relay.url, "websocket");
      await until(() => robot.isConnected, PATIENCE_MS);
      const script = await connect(robot, proxy.origin);
      terms.after(() => script.close());
      pairs.push({ name, robot, script, net: proxy });
    }
    const seen: Cut[] = [];
    const watch = async (pair: Pair): Promise<void> => {
      for (let n = 0; n < timesOf(terms.isLong); n++) {
        seen.push(await cutWhilePublishing(pair, dice));
      }
    };
    await Promise.all(pairs.map(watch));
    const compared = await scene.compare(relay.url);
    const old = seen.map(({ pair: { name, robot, script }, backAt, begun, stillMs }) => {
      const log = compared.logs.get(robot) ?? [];
      const posts = begun.map((seq) => script.diary.postedAt(log[seq - 1]?.key ?? null) ?? 0);
      const applied = posts.filter((at) => at < backAt - NEW_MS).length;
      if (applied > 1 || stillMs > 600) {
        terms.say(`${name}: still after ${Math.round(stillMs)} ms, ${applied} old values`);
      }
      return applied;
    });
    return [
      {
        label: "still after the cut, slowest",
        measured: Math.max(...seen.map(({ stillMs }) => stillMs)),
        bound: { atMost: 600 },
        unit: `ms, of ${seen.length}`,
      },
      {
        label: "old values that moved the robot after a reconnect, most",
        measured: Math.max(...old),
        bound: { atMost: 1 },
        unit: "",
      },
      ...compared.goals(),
    ];
  },
};

async function cutWhilePublishing(pair: Pair, dice: Dice): Promise<Cut> {
  const { robot, script, net } = pair;
  // On the spot, so that no wall ends it.
  const publish = (): void => script.post({ action: "drive", left: 0.3, right: -0.3 });
  await everyFor(PER_SECOND, 1_500, publish);
  const cutAt = machineNow();
  net.isUp = false;
  net.cut();
  const away = dice.between(1_000, 4_000);
  let lastMoveAt = cutAt;
  await everyFor(PER_SECOND, away, () => {
    publish();
    if (robot.isMoving) lastMoveAt = machineNow();
    else lastMoveAt = Math.max(lastMoveAt, robot.movedAt);
  });
  const backAt = machineNow();
  net.isUp = true;
  await sleep(AFTER_MS);
  await until(() => script.diary.unanswered === 0 && robot.isConnected, PATIENCE_MS);
  await sleep(AFTER_MS / 2);
  const begun = robot.starts.flatMap(({ seq, at }) => (at > backAt ? [seq] : []));
  return { pair, stillMs: lastMoveAt - cutAt, backAt, begun };
}
