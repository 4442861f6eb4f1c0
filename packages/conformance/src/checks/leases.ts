/** Leases: an endless motion stops when its script sends no requests. */
import type { CommandState, Order } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { openByLongPoll, type Connection } from "../connection.ts";
import { withEvents, type EventStream } from "../event-stream.ts";
import { pause, type Host } from "../host.ts";
import { must } from "../mismatch.ts";
import { moveToStart, mustStand } from "../pen.ts";

/**
 * ms from sending a command to its final state: the lease, with a tolerance that is larger for
 * network delays.
 */
export const FORWARD_MS = { least: 2_800, most: 5_000 };
const DRIVE_MS = { least: 400, most: 2_500 };
const LONG_DRIVE_MS = { least: 1_900, most: 4_500 };
/** distance in cm at which the robot does not touch the far wall */
const FAR_WALL = 50;
/** ms, longer than any lease */
const TIMEOUT_MS = 8_000;
/** Number of drives in one burst, and how many of them may start. Three drives are no burst yet. */
const BURST = 12;
const BURST_STARTS = 4;
/** A busy machine may process one burst in several parts, but hardly each of them. */
const BURST_ATTEMPTS = 3;

/**
 * States of a command whose lease has not ended. The robot may reach the wall earlier than
 * expected.
 */
const RENEWED: readonly CommandState[] = ["started", "collided"];

/** Slowly forward, and back again. */
const AHEAD = { action: "drive", left: 0.05, right: 0.05 } as const;
const BACK = { action: "drive", left: -0.05, right: -0.05 } as const;
const STILL = { action: "drive", left: 0, right: 0 } as const;

export const leases: CheckGroup = {
  title: "Dead man's switch and leases",
  checks: [
    {
      promise: "silence",
      name: "forward ends 3 s after the last request of its script, and the robot stands",
      run: async (host) => {
        await moveToStart(host);
        await withEvents(host, async (events) => {
          // The open event stream does not count as activity: this script sends no requests.
          mustLast(await durationOf(host, events, { action: "forward" }), FORWARD_MS);
        });
        await mustStand(host);
      },
    },
    {
      promise: "silence-reverse",
      name: "reverse ends in the same way",
      run: async (host) => {
        await toTheFarWall(host);
        await withEvents(host, async (events) => {
          mustLast(await durationOf(host, events, { action: "reverse" }), FORWARD_MS);
        });
        await mustStand(host);
      },
    },
    {
      promise: "renewed-by-reading",
      name: "forward continues while its script reads the sensors",
      run: async (host) => {
        await moveToStart(host);
        const { seq } = await host.send({ action: "forward" });
        for (let n = 0; n < 7; n++) {
          await pause(500);
          await host.snapshot("");
        }
        const { state } = await host.record(seq);
        must(RENEWED.includes(state), "started after 3.5 s of reading", state);
        await host.sendAndWait({ action: "stop" });
      },
    },
    {
      promise: "renewed-by-waiting",
      name: "reverse continues while a request of its script waits for its response",
      run: async (host) => {
        await toTheFarWall(host);
        const { seq } = await host.send({ action: "reverse" });
        const { state } = await host.record(seq, 3.5);
        must(RENEWED.includes(state), "started after a request that waited 3.5 s", state);
        await host.sendAndWait({ action: "stop" });
        await moveToStart(host);
      },
    },
    {
      promise: "drive-lease",
      name: "drive ends 0.5 s after its start, and the robot stands",
      run: async (host) => {
        await bothMustLast(host, [AHEAD, BACK], DRIVE_MS);
        await mustStand(host);
      },
    },
    {
      promise: "drive-lease-asked",
      name: "drive ends after the lease in its command",
      run: async (host) => {
        await withEvents(host, async (events) => {
          mustLast(await durationOf(host, events, { ...STILL, lease: 2_000 }), LONG_DRIVE_MS);
        });
      },
    },
    {
      promise: "drive-not-renewed",
      name: "reading does not renew a drive",
      run: async (host) => {
        await withEvents(host, async (events) => {
          let isOver = false;
          const read = async (): Promise<void> => {
            while (!isOver) {
              await host.snapshot("");
              await pause(200);
            }
          };
          const end = durationOf(host, events, { ...STILL, lease: 2_000 }).finally(() => {
            isOver = true;
          });
          const [ms] = await Promise.all([end, read()]);
          mustLast(ms, LONG_DRIVE_MS);
        });
      },
    },
    {
      promise: "drive-renewed",
      name: "the next drive renews a drive",
      run: async (host) => {
        await withEvents(host, async (events) => {
          const lease = 2_000;
          const first = await host.send({ ...AHEAD, lease });
          await events.started(first.seq);
          await pause(700);
          const ms = await durationOf(host, events, { ...BACK, lease });
          const { record } = await events.ended(first.seq, TIMEOUT_MS);
          const isTaken = ["completed", "superseded"].includes(record.state);
          must(isTaken, "the first to end when the second starts", record);
          mustLast(ms, LONG_DRIVE_MS);
        });
      },
    },
    {
      promise: "drive-newest",
      name: "of several waiting drives the newest runs",
      run: async (host) => {
        await host.send({ ...STILL, milliseconds: 2_000 });
        const waits = [];
        for (let n = 0; n < 3; n++) waits.push(await host.send(STILL));
        const states = [];
        for (const { seq } of waits) states.push((await host.waitForEnd(seq)).state);
        const wanted = ["superseded", "superseded", "cancelled"];
        must(states.join() === wanted.join(), wanted.join(), states.join());
      },
    },
    {
      promise: "drive-burst",
      name: "only the last drive of a burst runs",
      needs: ["long-poll"],
      run: async (host) => {
        await withEvents(host, async (events) => {
          // One request delivers all commands at once, however slow the network is.
          const connection = await openByLongPoll(host);
          let started: number[] = [];
          for (let attempt = 0; attempt < BURST_ATTEMPTS; attempt++) {
            started = await startedOfBurst(host, events, connection);
            if (started.length <= BURST_STARTS) break;
          }
          const few = started.length <= BURST_STARTS && started.at(-1) === BURST - 1;
          must(few, `the last of ${BURST} to start, after at most 3 others`, started);
          await connection.close();
        });
      },
    },
    {
      promise: "runs-to-end",
      name: "a drive with milliseconds runs to its end, even if its script sends nothing",
      run: async (host) => {
        await withEvents(host, async (events) => {
          const { seq } = await host.send({ ...STILL, milliseconds: 4_000 });
          const { record } = await events.ended(seq, 15_000);
          must(record.state === "completed", "completed", record);
        });
      },
    },
    {
      promise: "gives-way",
      name: "the next command ends a motion without an end",
      run: async (host) => {
        const still = await host.send({ ...STILL, lease: 2_000 });
        const next = await host.sendAndWait({ ...STILL, milliseconds: 50 });
        must(next.state === "completed", "completed", next);
        const { state } = await host.record(still.seq);
        must(["completed", "superseded"].includes(state), "completed or superseded", state);
        const forward = await host.send({ action: "forward" });
        await host.sendAndWait({ action: "left 90" });
        const after = await host.record(forward.seq);
        const isOver = ["completed", "superseded"].includes(after.state);
        must(isOver, "completed or superseded", after.state);
        await host.sendAndWait({ action: "right 90" });
      },
    },
  ],
};

/** Moves the robot so that it can `reverse` for the whole lease without touching a wall. */
async function toTheFarWall(host: Host): Promise<void> {
  const { sensors } = await host.snapshot();
  await host.sendAndWait({ action: "move", distance: sensors.front - FAR_WALL });
}

/** Sends an endless motion. @returns ms until the host cancelled it */
async function durationOf(host: Host, events: EventStream, order: Order): Promise<number> {
  const sentAt = performance.now();
  const { seq } = await host.send(order);
  const end = await events.ended(seq, TIMEOUT_MS);
  must(end.record.state === "cancelled", `${order.action} to end as cancelled`, end.record);
  return end.at - sentAt;
}

/** Runs two motions: a network delay can lengthen one of them, but hardly both. */
async function bothMustLast(
  host: Host,
  orders: readonly [Order, Order],
  range: typeof DRIVE_MS,
): Promise<void> {
  await withEvents(host, async (events) => {
    const durations: number[] = [];
    for (const order of orders) durations.push(await durationOf(host, events, order));
    mustLast(Math.min(...durations), range);
  });
}

/** Sends a burst of drives. @returns the positions in the burst of those that started */
async function startedOfBurst(
  host: Host,
  events: EventStream,
  connection: Connection,
): Promise<number[]> {
  const { seq } = await host.sendAndWait({ action: "stop" });
  const command = { ...STILL, lease: 1_000 };
  const message = () => ({ type: "command", key: host.newKey(), command });
  await connection.sendAll(Array.from({ length: BURST }, message));
  const { record } = await events.ended(seq + BURST, TIMEOUT_MS);
  must(record.state === "cancelled", "the last one to end with its lease", record);
  return events.states
    .filter((each) => each.record.state === "started" && each.record.seq > seq)
    .map((each) => each.record.seq - seq - 1);
}

export function mustLast(ms: number, { least, most }: { least: number; most: number }): void {
  const range = `an ending after ${least / 1_000} to ${most / 1_000} s`;
  must(ms >= least && ms <= most, range, `${(ms / 1_000).toFixed(1)} s`);
}
