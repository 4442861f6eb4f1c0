/**
 * Twenty robots, ten commands a second each, on a net without faults: nothing is lost, and all is
 * quick.
 */
import { RelayProcess } from "../../support/relay-process.ts";
import { everyFor, sleep, until } from "../clock.ts";
import { percentile } from "../percentile.ts";
import type { Row } from "../row.ts";
import { Scene } from "../scene.ts";
import { RequestScript } from "../scripts/request-script.ts";
import type { Script } from "../scripts/script.ts";
import { SocketScript } from "../scripts/socket-script.ts";
import { shortOrder } from "../orders.ts";

const ROBOTS = 20;
const PER_SECOND = 10;
const SHORT_MS = 60_000;
const LONG_MS = 600_000;

export const cleanNet: Row = {
  title: "Clean net",
  does: (isLong) =>
    `${ROBOTS} robots x ${PER_SECOND} commands a second, half by WebSocket, half by single requests, for ${length(isLong) / 1000} s`,
  run: async (terms) => {
    const relay = await RelayProcess.start();
    terms.after(() => relay.stop());
    const scene = new Scene(terms);
    await scene.register(relay.url, ROBOTS);
    const pages = await scene.startPages();
    for (const robot of scene.robots) scene.open(robot, pages, relay.url, "both");
    await scene.allConnected();
    const scripts: Script[] = [];
    for (const [n, robot] of scene.robots.entries()) {
      const script =
        n % 2 === 0
          ? await SocketScript.connect(robot, relay.url, "both")
          : new RequestScript(robot, relay.url);
      terms.after(() => script.close());
      scripts.push(script);
    }
    await sleep(1_000);

    // Not all in the same moment: scripts know nothing of each other.
    const total = ROBOTS * PER_SECOND;
    await everyFor(total, length(terms.isLong), (n) => {
      scripts[n % ROBOTS]?.post(shortOrder(Math.floor(n / ROBOTS)));
    });
    await until(() => scripts.every(({ diary }) => diary.unanswered === 0), 10_000);
    await sleep(2_000);

    const compared = await scene.compare(relay.url);
    const waits = scene.robots.flatMap((robot, n) => {
      const starts = new Map(robot.starts.map(({ seq, at }) => [seq, at]));
      return (compared.logs.get(robot) ?? []).flatMap(({ seq, key }) => {
        const start = starts.get(seq);
        const posted = scripts[n]?.diary.postedAt(key);
        return start === undefined || posted === undefined ? [] : [start - posted];
      });
    });
    const posted = scripts.reduce((sum, { diary }) => sum + diary.posted, 0);
    return [
      {
        label: "posted commands that did not start",
        measured: posted - waits.length,
        bound: { atMost: 0 },
        unit: `of ${posted}`,
      },
      ...compared.goals(),
      {
        label: "post to start, p50",
        measured: percentile(waits, 50),
        bound: { atMost: 50 },
        unit: "ms",
      },
      {
        label: "post to start, p99",
        measured: percentile(waits, 99),
        bound: { atMost: 250 },
        unit: "ms",
      },
    ];
  },
};

function length(isLong: boolean): number {
  return isLong ? LONG_MS : SHORT_MS;
}
