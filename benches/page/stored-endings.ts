/**
 * Measures frames while a script drives with short commands at 1x: the page stores the run before it
 * reports each ending. The baseline is one long command, which stores nothing meanwhile.
 */
import { api, copyAddress } from "../../e2e/support/remote-robot.ts";
import type { Goal } from "../core/goals.ts";
import { quantile } from "../core/measure.ts";
import { traceFrames, type FrameTimes } from "./frame-times.ts";
import type { PageUnderTest, Section } from "./section.ts";
import { waitUntilStored } from "./wait-until-stored.ts";

const ROUNDS = 3;
const TRACE_MS = 3000;
const FRAME_MS = 1000 / 60;
/** Factor by which a slow computer's worker is assumed to be slower. */
const SLOWER = 4;
const SHORT = { action: "turn", degrees: 11 };
const LONG = { action: "turn", degrees: 3600 };

export const storedEndings: Section = { title: "Stored endings", measure };

async function measure({ browser, url }: PageUnderTest): Promise<readonly Goal[]> {
  const permissions = ["clipboard-read", "clipboard-write"];
  const viewport = { width: 1440, height: 900 };
  const page = await browser.newPage({ permissions, viewport, baseURL: url });
  page.setDefaultTimeout(120_000);
  await page.goto("/");
  const address = await copyAddress(page);
  await page.waitForLoadState("networkidle");
  await waitUntilStored(page);
  const [short, long] = [emptyTimes(), emptyTimes()];
  let endings = 0;
  for (let round = 0; round < ROUNDS; round++) {
    await end(address, await submit(address, { action: "stop" }));
    await submit(address, LONG);
    append(long, await traceFrames(browser, page, TRACE_MS));
    await end(address, await submit(address, { action: "stop" }));
    const script = driveInShortTurns(address);
    append(short, await traceFrames(browser, page, TRACE_MS));
    endings += await script.stop();
  }
  await page.close();
  console.log(`  ${endings} endings in ${ROUNDS} rounds of ${TRACE_MS / 1000} s`);
  print("one long command", long);
  print("short commands", short);
  return [
    {
      label: "frames on time while endings are stored",
      measured: onTime(short.mainThread, 1),
      bound: { atLeast: 99 },
      unit: "%",
    },
    {
      label: `worker frames on time while endings are stored, calculated for a ${SLOWER} times slower worker`,
      measured: onTime(short.workerFrames, SLOWER),
      bound: { atLeast: 99 },
      unit: "%",
    },
  ];
}

type Times = Pick<FrameTimes, "mainThread" | "workerFrames">;

function emptyTimes(): Times {
  return { mainThread: [], workerFrames: [] };
}

function append(to: Times, { mainThread, workerFrames }: FrameTimes): void {
  to.mainThread.push(...mainThread);
  to.workerFrames.push(...workerFrames);
}

function onTime(frames: readonly number[], slower: number): number {
  return (100 * frames.filter((ms) => ms * slower <= FRAME_MS).length) / frames.length;
}

function print(name: string, { mainThread, workerFrames }: Times): void {
  const of = (frames: readonly number[]): string =>
    `p50 ${quantile(frames, 0.5).toFixed(2)}, p99 ${quantile(frames, 0.99).toFixed(2)}, max ${Math.max(...frames).toFixed(1)} ms`;
  console.log(`  ${name.padEnd(16)}  main ${of(mainThread)}; worker ${of(workerFrames)}`);
}

/** Submits turns one after another, each after the ending of the previous one. */
function driveInShortTurns(address: string): { stop: () => Promise<number> } {
  let isOver = false;
  let endings = 0;
  const driving = (async () => {
    while (!isOver) {
      await end(address, await submit(address, SHORT));
      endings++;
    }
  })();
  return {
    stop: async () => {
      isOver = true;
      await driving;
      return endings;
    },
  };
}

/** @returns the command's number */
async function submit(address: string, command: object): Promise<number> {
  const response = await api(address, "/commands", command);
  if (!response.ok) throw new Error(`the command was rejected: ${await response.text()}`);
  return (await response.json()).seq;
}

async function end(address: string, seq: number): Promise<void> {
  const { state, reason } = await (await api(address, `/commands/${seq}?wait=20`)).json();
  if (state !== "completed") throw new Error(`the command ended as ${state}: ${reason}`);
}
