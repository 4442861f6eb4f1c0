/**
 * Scripts that sleep while their robots move: they cost the relay little, and nobody else waits for
 * them.
 */
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { RelayProcess } from "../../support/relay-process.ts";
import { machineNow, sleep } from "../clock.ts";
import { RawSocket } from "../net/raw-socket.ts";
import { percentile } from "../percentile.ts";
import type { Row } from "../row.ts";
import { Scene } from "../scene.ts";
import { LineScript } from "../scripts/line-script.ts";

const BUSY = 5;
/** as many as one key lets connect, less the one that drives */
const READERS_EACH = 4;
const BYSTANDERS = 3;
const BEFORE_MS = 20_000;
const SLEEP_MS = 60_000;
/** what has gathered comes at once; what is new meanwhile is next to nothing */
const WAKING_MS = 150;

export const slowReaders: Row = {
  title: "Slow readers",
  does: () =>
    `${BUSY * READERS_EACH} scripts of ${BUSY} robots that drive without a pause read nothing for ${SLEEP_MS / 1000} s, beside ${BYSTANDERS} that are driven`,
  run: async (terms) => {
    const relay = await RelayProcess.start();
    terms.after(() => relay.stop());
    const scene = new Scene(terms);
    await scene.register(relay.url, BUSY + BYSTANDERS);
    const pages = await scene.startPages();
    for (const robot of scene.robots) scene.open(robot, pages, relay.url, "websocket");
    await scene.allConnected();

    let isOver = false;
    const busy = scene.robots.slice(0, BUSY).map(async ({ registration: { id, ownerKey } }) => {
      const robot = `${relay.url}/api/v1/robots/${id}`;
      const made = await fetch(`${robot}/keys`, {
        method: "POST",
        headers: { authorization: `Bearer ${ownerKey}`, "content-type": "application/json" },
        body: '{"kind":"drive"}',
      });
      const { key } = await made.json();
      const script = await LineScript.connect(relay.url, id, key);
      terms.after(() => script.close());
      for (let n = 0; !isOver; n++) await script.run({ action: n % 2 ? "left 90" : "right 90" });
    });
    const waits: { at: number; ms: number }[] = [];
    const others = scene.robots.slice(BUSY).map(async ({ registration: { id, driverKey } }) => {
      const script = await LineScript.connect(relay.url, id, driverKey);
      terms.after(() => script.close());
      while (!isOver) {
        const at = machineNow();
        await script.post({ action: "stop" });
        waits.push({ at, ms: machineNow() - at });
        // As often as one key may stop.
        await sleep(250);
      }
    });
    const readers: RawSocket[] = [];
    for (const { registration } of scene.robots.slice(0, BUSY)) {
      for (let n = 0; n < READERS_EACH; n++) {
        const { id, driverKey: key } = registration;
        const reader = await RawSocket.open(relay.url, `/api/v1/robots/${id}/socket`);
        terms.after(() => reader.destroy());
        reader.text(JSON.stringify({ type: "hello", version: 1, role: "drive", key }));
        readers.push(reader);
      }
    }
    // While they are awake they say that they have read all.
    const seen = `{"type":"seen","seq":${Number.MAX_SAFE_INTEGER}}`;
    const reading = setInterval(() => {
      for (const reader of readers) reader.text(seen);
    }, 100);
    await sleep(BEFORE_MS);
    clearInterval(reading);
    const memoryBefore = memoryMib(relay.pid);
    const asleepAt = machineNow();
    for (const reader of readers) reader.sleep();
    let memory = memoryBefore;
    while (machineNow() - asleepAt < SLEEP_MS) {
      await sleep(1_000);
      memory = Math.max(memory, memoryMib(relay.pid));
    }
    const wokeAt = machineNow();
    const read = readers.map(({ received }) => received);
    for (const reader of readers) reader.wake();
    await sleep(WAKING_MS);
    const backlogs = readers.map(({ received }, n) => received - (read[n] ?? 0));
    isOver = true;
    await Promise.all([...busy, ...others]);

    const p99 = (from: number, to: number): number =>
      percentile(
        waits.filter(({ at }) => at >= from && at < to).map(({ ms }) => ms),
        99,
      );
    const before = p99(asleepAt - BEFORE_MS, asleepAt);
    const during = p99(asleepAt, wokeAt);
    terms.say(
      `p99 of a stop until it is stored: ${before.toFixed(1)} ms before, ${during.toFixed(1)} ms meanwhile`,
    );
    return [
      {
        label: "memory of the relay, more than before",
        measured: memory - memoryBefore,
        bound: { atMost: 48 },
        unit: "MiB",
      },
      {
        label: "p99 of the others, times that before",
        measured: during / before,
        bound: { atMost: 1.5 },
        unit: "times",
      },
      {
        label: "what a reader finds on waking, at most",
        measured: Math.max(...backlogs) / 1024,
        bound: { atMost: 64 },
        unit: "KiB",
      },
    ];
  },
};

/** Read from a file where there is one: to start a program would hold up the clocks of this one. */
function memoryMib(pid: number): number {
  const file = `/proc/${pid}/status`;
  if (existsSync(file)) {
    return Number(/VmRSS:\s+(\d+) kB/.exec(readFileSync(file, "utf8"))?.[1]) / 1024;
  }
  const { stdout } = spawnSync("ps", ["-o", "rss=", "-p", String(pid)], { encoding: "utf8" });
  return Number(stdout) / 1024;
}
