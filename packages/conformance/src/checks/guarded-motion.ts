/** Guarded motions: conditions end `forward`, `reverse` and `drive` on the robot itself. */
import type { Order, UntilCondition } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { withEvents } from "../event-stream.ts";
import type { Host } from "../host.ts";
import { must } from "../mismatch.ts";
import {
  moved,
  moveToStart,
  mustHaveReadings,
  mustStand,
  readings,
  START_READINGS,
} from "../pen.ts";
import { FORWARD_MS, mustLast } from "./leases.ts";

/** ms, longer than the motions of these checks */
const TIMEOUT_MS = 15_000;
/** cm driven by a motion with a condition */
const DISTANCE = 100;

/** True from the start. */
const NOW: UntilCondition[] = [{ sensor: "front", is: ">=", than: 0 }];
/** Never true: no reading is below 0, and the pen is small. */
const NEVER: UntilCondition[] = [
  { sensor: "front", is: "<", than: 0 },
  { sensor: "left", is: ">", than: "right", plus: 9_999 },
];
const FORWARD = { action: "forward", until: NEVER } as const satisfies Order;

/** A condition that becomes true after `DISTANCE`. */
const NEARER: UntilCondition = {
  sensor: "front",
  is: "<=",
  than: START_READINGS.front - DISTANCE,
};

export const guardedMotion: CheckGroup = {
  title: "Guarded motion",
  checks: [
    {
      promise: "until",
      name: "forward with until ends as completed when a condition is true, and the robot stands",
      run: async (host) => {
        await moveToStart(host);
        const until = [...NEVER, NEARER];
        const end = await host.sendAndWait({ action: "forward", until });
        must(end.state === "completed", "completed", end);
        const expected = moved(START_READINGS, DISTANCE);
        await mustHaveReadings(host, expected, "after a motion until front <= 350");
        await mustStand(host);
        const than = START_READINGS.back + 5;
        const back = [{ sensor: "back", is: "<", than } as const];
        const other = await host.sendAndWait({ action: "reverse", until: [...NEVER, ...back] });
        must(other.state === "completed", "reverse to end as completed", other);
      },
    },
    {
      promise: "until-start",
      name: "a condition that is true at the start ends the motion as completed, without a motion",
      run: async (host) => {
        await moveToStart(host);
        const orders: Order[] = [
          { action: "forward", until: NOW },
          { action: "drive", left: 0.5, right: 0.5, until: NOW },
        ];
        for (const order of orders) {
          const end = await host.sendAndWait(order);
          const isRight = end.state === "completed" && end.distance === 0;
          must(isRight, "completed with the distance 0", end);
        }
      },
    },
    {
      promise: "until-goal",
      name: "a goal ends a guarded motion as completed",
      needs: ["goal"],
      run: async (host) => {
        await moveToStart(host);
        const end = await host.sendAndWait({
          action: "forward",
          until: [...NEVER, { goal: true }],
        });
        must(end.state === "completed", "completed", end);
        await moveToStart(host);
      },
    },
    {
      promise: "until-collided",
      name: "a wall ends a guarded motion as collided",
      needs: ["bumps"],
      run: async (host) => {
        await moveToStart(host);
        const end = await host.sendAndWait(FORWARD);
        must(end.state === "collided", "collided", end);
        await moveToStart(host);
      },
    },
    {
      promise: "until-waits",
      name: "the next command waits for the end of a guarded motion",
      run: async (host) => {
        await moveToStart(host);
        const { seq } = await host.send({ action: "forward", until: [NEARER] });
        const next = await host.sendAndWait({ action: "turn", degrees: 0 });
        must(next.state === "completed", "completed", next);
        const { state } = await host.record(seq);
        must(state === "completed", "completed", state);
        await mustHaveReadings(host, moved(START_READINGS, DISTANCE), "before the next command");
        await moveToStart(host);
      },
    },
    {
      promise: "until-drive",
      name: "a guarded drive is no velocity: each one runs, and longer than its 0.5 s",
      run: async (host) => {
        await moveToStart(host);
        const slow = { action: "drive", left: 0.2, right: 0.2 } as const;
        const first = await host.send({ ...slow, until: [NEARER] });
        const second = await host.send({ ...slow, until: NOW });
        await host.sendAndWait({ ...slow, until: NOW });
        for (const { seq } of [first, second]) {
          const { state } = await host.record(seq);
          must(state === "completed", "completed", state);
        }
        await moveToStart(host);
      },
    },
    {
      promise: "until-silence",
      name: "a guarded motion ends 3 s after the last request of its script",
      run: async (host) => {
        await moveToStart(host);
        await withEvents(host, async (events) => {
          const sentAt = performance.now();
          const still = { action: "drive", left: 0, right: 0, until: NEVER } as const;
          const { seq } = await host.send(still);
          const { record, at } = await events.ended(seq, TIMEOUT_MS);
          must(record.state === "cancelled", "cancelled", record);
          mustLast(at - sentAt, FORWARD_MS);
        });
      },
    },
    {
      promise: "until-ended-early",
      name: "stop, replace and cancel end a guarded motion",
      run: async (host) => {
        const still = { action: "drive", left: 0, right: 0, until: NEVER } as const;
        const end = { action: "turn", degrees: 0 } as const;
        const started = await startedOf(host, still);
        await host.sendAndWait({ action: "stop" });
        await mustBe(host, started, "cancelled");
        const replaced = await startedOf(host, still);
        await host.sendAndWait({ ...end, replace: true });
        await mustBe(host, replaced, "superseded");
        const cancelled = await startedOf(host, still);
        await host.request(`/commands/${cancelled}`, { method: "DELETE" });
        await host.sendAndWait(end);
        await mustBe(host, cancelled, "cancelled");
      },
    },
    {
      promise: "until-key",
      name: "the record contains until, and another until under the same key is a conflict",
      run: async (host) => {
        const key = host.newKey();
        const sent = { action: "forward", until: NOW } as const;
        const first = await host.send(sent, key);
        const { until } = first.command;
        must(JSON.stringify(until) === JSON.stringify(NOW), JSON.stringify(NOW), first.command);
        const again = await host.send(sent, key);
        must(again.duplicate && again.seq === first.seq, "the first record", again);
        const headers = { "Idempotency-Key": key };
        const body = { ...sent, until: [{ sensor: "front", is: ">=", than: 1 }] };
        const other = await host.request("/commands", { method: "POST", body, headers });
        must(other.status === 409, "409 for another until", `${other.status} ${other.text}`);
        await host.waitForEnd(first.seq);
      },
    },
    {
      promise: "until-invalid",
      name: "an invalid until is rejected with 400, and the robot stands",
      run: async (host) => {
        const before = await readings(host);
        const near = { sensor: "front", is: "<=", than: 60 };
        const bodies = [
          { action: "drive", left: 0, right: 0, milliseconds: 50, until: NEVER },
          { action: "drive", left: 0, right: 0, lease: 500, until: NEVER },
          { action: "move", distance: 10, until: NEVER },
          { action: "stop", until: NEVER },
          { action: "forward", until: [] },
          { action: "forward", until: Array.from({ length: 201 }, () => near) },
          { action: "forward", until: [{ ...near, is: "=" }] },
          { action: "forward", until: [{ ...near, than: 100_001 }] },
          { action: "forward", until: [{ goal: false }] },
        ];
        for (const body of bodies) {
          const response = await host.request("/commands", { method: "POST", body });
          const what = JSON.stringify(body).slice(0, 80);
          must(response.status === 400, `400 for ${what}`, `${response.status} ${response.text}`);
        }
        await mustHaveReadings(host, before, "as before");
      },
    },
  ],
};

async function startedOf(host: Host, order: Order): Promise<number> {
  const { seq } = await host.send(order);
  await host.waitForStart(seq);
  return seq;
}

async function mustBe(host: Host, seq: number, wanted: string): Promise<void> {
  const { state } = await host.record(seq);
  must(state === wanted, wanted, state);
}
