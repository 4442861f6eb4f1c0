/**
 * Scripts stop reading while their robots move: they use little memory of the relay, and do not
 * delay other clients.
 */
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { machineNow, sleep } from "../clock.ts";
import { memoryMib } from "../memory.ts";
import { RawSocket } from "../net/raw-socket.ts";
import { percentile } from "../percentile.ts";
import type { Scenario } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";
import { BareSocketScript } from "../scripts/bare-socket-script.ts";

const BUSY = 5;
/** connection limit of a key, minus the script that drives */
const READERS_EACH = 4;
const BYSTANDERS = 3;
const BEFORE_MS = 20_000;
const SLEEP_MS = 60_000;
/** long enough to receive the backlog, and short enough to receive almost no new messages */
const WAKING_MS = 150;

export const slowReaders: Scenario = {
  title: "Slow readers",
  describe: () =>
    `${BUSY * READERS_EACH} scripts of ${BUSY} moving robots read nothing for ${SLEEP_MS / 1000} s while ${BYSTANDERS} other robots receive commands`,
  run: async (context) => {
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const testBed = new TestBed(context);
    await testBed.register(relay.url, BUSY + BYSTANDERS);
    const pages = await testBed.startPages();
    for (const robot of testBed.robots) testBed.open(robot, pages, relay.url, "websocket");
    await testBed.waitUntilConnected();

    let isOver = false;
    const busy = testBed.robots.slice(0, BUSY).map(async ({ registration: { id, ownerKey } }) => {
      const robot = `${relay.url}/api/v1/robots/${id}`;
      const created = await fetch(`${robot}/keys`, {
        method: "POST",
        headers: { authorization: `Bearer ${ownerKey}`, "content-type": "application/json" },
        body: '{"kind":"drive"}',
      });
      const { key } = await created.json();
      const script = await BareSocketScript.connect(relay.url, id, key);
      context.onCleanup(() => script.close());
      for (let n = 0; !isOver; n++) await script.run({ action: n % 2 ? "left 90" : "right 90" });
    });
    const waits: { at: number; ms: number }[] = [];
    const others = testBed.robots.slice(BUSY).map(async ({ registration: { id, driverKey } }) => {
      const script = await BareSocketScript.connect(relay.url, id, driverKey);
      context.onCleanup(() => script.close());
      while (!isOver) {
        const at = machineNow();
        await script.post({ action: "stop" });
        waits.push({ at, ms: machineNow() - at });
        // The rate limit for stop commands of one key.
        await sleep(250);
      }
    });
    const readers: RawSocket[] = [];
    for (const { registration } of testBed.robots.slice(0, BUSY)) {
      for (let n = 0; n < READERS_EACH; n++) {
        const { id, driverKey: key } = registration;
        const reader = await RawSocket.open(relay.url, `/api/v1/robots/${id}/socket`);
        context.onCleanup(() => reader.destroy());
        reader.text(JSON.stringify({ type: "hello", version: 1, role: "drive", key }));
        readers.push(reader);
      }
    }
    // While awake, they acknowledge all snapshots.
    const seen = `{"type":"seen","seq":${Number.MAX_SAFE_INTEGER}}`;
    const reading = setInterval(() => {
      for (const reader of readers) reader.text(seen);
    }, 100);
    await sleep(BEFORE_MS);
    clearInterval(reading);
    const memoryBefore = memoryMib(relay.pid);
    const asleepAt = machineNow();
    for (const reader of readers) reader.pause();
    let memory = memoryBefore;
    while (machineNow() - asleepAt < SLEEP_MS) {
      await sleep(1_000);
      memory = Math.max(memory, memoryMib(relay.pid));
    }
    const wokeAt = machineNow();
    const read = readers.map(({ received }) => received);
    for (const reader of readers) reader.resume();
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
    context.log(
      `p99 of a stop until it is stored: ${before.toFixed(1)} ms before, ${during.toFixed(1)} ms during the pause`,
    );
    return [
      {
        label: "increase of the relay's memory",
        measured: memory - memoryBefore,
        bound: { atMost: 48 },
        unit: "MiB",
      },
      {
        label: "p99 of the other clients, relative to before",
        measured: during / before,
        bound: { atMost: 1.5 },
        unit: "times",
      },
      {
        label: "largest backlog of a reader that resumes",
        measured: Math.max(...backlogs) / 1024,
        bound: { atMost: 64 },
        unit: "KiB",
      },
    ];
  },
};
