/** The net of pages and of scripts is cut all the time, each line by itself, and mends. */
import { Dice } from "../../../apps/relay/src/testing/faults/dice.ts";
import { RelayProcess } from "../../support/relay-process.ts";
import { machineNow, sleep, until } from "../clock.ts";
import { FaultProxy } from "../net/fault-proxy.ts";
import { percentile } from "../percentile.ts";
import type { Robot } from "../robots/robot.ts";
import type { Row, Terms } from "../row.ts";
import { Scene } from "../scene.ts";
import type { Script } from "../scripts/script.ts";
import { Traffic } from "../traffic.ts";

const ROBOTS = 9;
const PER_SECOND = 3;
const SHORT_CUTS = 2_000;
const LONG_CUTS = 20_000;
/** A line that does not resume within this is counted so, and left. */
const GIVE_UP_MS = 20_000;

const cutsOf = (isLong: boolean): number => (isLong ? LONG_CUTS : SHORT_CUTS);

/** The net of one client, which breaks by itself. */
interface Line {
  proxy: FaultProxy;
  isPage: boolean;
  isResumed(since: number): boolean;
}

export const cuts: Row = {
  title: "Cuts",
  does: (isLong) =>
    `${cutsOf(isLong).toLocaleString("en")} cuts of the lines of ${ROBOTS} pages and their scripts: resets, closes, outages of up to 1 s, half-open lines, delays, slices`,
  run: async (terms) => {
    const dice = new Dice(terms.seed);
    const relay = await RelayProcess.start();
    terms.after(() => relay.stop());
    const net = (): Promise<FaultProxy> => startNet(relay, dice, terms);
    const scene = new Scene(terms);
    await scene.register(relay.url, ROBOTS);
    const pages = await scene.startPages();
    const lines: Line[] = [];
    const scriptNets = new Map<Robot, FaultProxy>();
    for (const [n, robot] of scene.robots.entries()) {
      const proxy = await net();
      scene.open(robot, pages, proxy.origin, n % 2 === 0 ? "both" : "websocket");
      lines.push({
        proxy,
        isPage: true,
        isResumed: (since) => robot.isConnected && proxy.answeredAt > since,
      });
      scriptNets.set(robot, await net());
    }
    await scene.allConnected();
    const scripts = await scene.scripts((robot) => scriptNets.get(robot)?.origin ?? "");
    for (const [n, robot] of scene.robots.entries())
      lines.push(scriptLine(scripts[n], scriptNets.get(robot)));
    const traffic = new Traffic(scripts, PER_SECOND, dice);

    const toDo = { cuts: cutsOf(terms.isLong) };
    const resumed = (await Promise.all(lines.map((line) => breakAgain(line, toDo, dice)))).flat();
    for (const { proxy } of lines) proxy.mend();
    await traffic.settle(scene.robots, relay.url);
    const compared = await scene.compare(relay.url);
    return [
      {
        label: "cuts",
        measured: resumed.length,
        bound: { atLeast: cutsOf(terms.isLong) },
        unit: "",
      },
      ...compared.goals(),
      {
        label: "resumed after the net is back, p50",
        measured: percentile(resumed, 50),
        bound: { atMost: 3_000 },
        unit: "ms",
      },
      {
        label: "resumed after the net is back, slowest",
        measured: Math.max(...resumed),
        bound: { atMost: 3_000 },
        unit: "ms",
      },
    ];
  },
};

async function startNet(relay: RelayProcess, dice: Dice, terms: Terms): Promise<FaultProxy> {
  const proxy = await FaultProxy.start({ target: () => relay.port, dice });
  terms.after(() => proxy.close());
  return proxy;
}

function scriptLine(script: Script | undefined, proxy: FaultProxy | undefined): Line {
  if (script === undefined || proxy === undefined) throw new Error("a robot has no script");
  return { proxy, isPage: false, isResumed: (since) => proxy.answeredAt > since };
}

/**
 * Breaks a line until enough were broken. @returns ms from each time the net was back to the answer
 */
async function breakAgain(line: Line, toDo: { cuts: number }, dice: Dice): Promise<number[]> {
  const { proxy, isPage } = line;
  const resumed: number[] = [];
  while (toDo.cuts > 0) {
    await sleep(dice.between(50, 700));
    proxy.isSlicing = dice.isLucky(0.3);
    // What a script without our library sends has no time: a command that is held up on its way
    // starts late.
    proxy.delay = dice.isLucky(0.3) ? { least: 0, most: isPage ? 40 : 15 } : { least: 0, most: 0 };
    if (isPage && dice.isLucky(0.1)) proxy.hold(dice.between(100, 1_500));
    const cut = breakOnce(proxy, dice);
    if (cut === null) continue;
    toDo.cuts -= 1;
    await sleep(cut.backAt - machineNow());
    await until(() => line.isResumed(cut.cutAt), GIVE_UP_MS);
    resumed.push(Math.max(0, machineNow() - cut.backAt));
  }
  return resumed;
}

/** @returns when the net is back; null where nothing was open */
function breakOnce(proxy: FaultProxy, dice: Dice): { cutAt: number; backAt: number } | null {
  if (proxy.connections === 0) return null;
  const cutAt = machineNow();
  const chance = dice.next();
  if (chance < 0.7) {
    proxy.cut();
    return { cutAt, backAt: cutAt };
  }
  const ms = dice.between(50, 1_000);
  if (chance < 0.85) proxy.breakFor(ms);
  else proxy.halfOpen(dice.pick(["client", "relay"]), ms);
  return { cutAt, backAt: cutAt + ms };
}
