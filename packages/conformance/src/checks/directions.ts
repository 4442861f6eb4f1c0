/** Units, sides, directions and signs, measured by the range sensors in a pen of known size. */
import {
  type CommandRecord,
  type Order,
  type SensorReadings,
  type Snapshot,
  TICKS_PER_SECOND,
} from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { pause, type Host } from "../host.ts";
import { must, Mismatch } from "../mismatch.ts";
import {
  areNear,
  moveToStart,
  START_READINGS,
  isNear,
  moved,
  mustHaveReadings,
  readings,
  show,
  turned,
} from "../pen.ts";

/** cm, longer than the distance from START_READINGS to the right wall */
const TO_THE_WALL = 60;
/** A robot reports at least once a second, also while it stands. */
const REPORT_MS = 5_000;
const DRIVE_MS = 1_500;
/** The wheels turn the robot by about 20 degrees at a time; a quarter turn takes fewer turns. */
const MAX_WHEEL_TURNS = 20;

export const directions: CheckGroup = {
  title: "Units, directions and signs",
  checks: [
    {
      promise: "unit-length",
      name: "readings are in cm from the robot's centre: 50, 50, 150 and 450 in the pen",
      run: async (host) => {
        const sorted = (values: SensorReadings) => Object.values(values).toSorted((a, b) => a - b);
        const found = await readings(host);
        const wanted = sorted(START_READINGS);
        const areExpected = sorted(found).every((cm, index) => isNear(cm, wanted[index] ?? 0));
        must(areExpected, "about 50, 50, 150 and 450", show(found));
      },
    },
    {
      promise: "reading-newer",
      name: "with `after`, a reading waits for a newer snapshot",
      run: async (host) => {
        const first = await host.snapshot();
        const startedAt = performance.now();
        const next = await host.snapshot(`?after=${first.seq}&wait=10`);
        const waited = performance.now() - startedAt;
        must(next.seq > first.seq, `a seq above ${first.seq}`, next.seq);
        must(waited < REPORT_MS, "a report every second", `${Math.round(waited)} ms`);
      },
    },
    {
      promise: "tick",
      name: "`tick` counts 1/60 s",
      run: async (host) => {
        const first = await host.snapshot(`?after=${(await host.snapshot()).seq}&wait=5`);
        const startedAt = performance.now();
        await pause(2_000);
        const last = await host.snapshot(`?after=${(await host.snapshot()).seq}&wait=5`);
        const ticks = (last.tick - first.tick) / ((performance.now() - startedAt) / 1_000);
        must(ticks > 30 && ticks < 120, "about 60 a second", Math.round(ticks));
      },
    },
    {
      promise: "fresh-reading",
      name: "a reading after a final state is never older than that state",
      run: async (host) => {
        for (let n = 0; n < 2; n++) {
          await host.sendAndWait({ action: "left 90" });
          const first = await host.snapshot("");
          await pause(700);
          const later = await host.snapshot(`?after=${first.seq}&wait=5`);
          must(areNear(first.sensors, later.sensors), show(later.sensors), show(first.sensors));
        }
        for (let n = 0; n < 2; n++) await host.sendAndWait({ action: "left 90" });
      },
    },
    {
      promise: "sides",
      name: "front, right, back and left are the sides of the robot",
      run: async (host) => {
        await mustHaveReadings(host, START_READINGS, "in the near right corner of the pen");
        await complete(host, { action: "left 90" }, { action: "left 90" });
        await mustHaveReadings(host, turned(START_READINGS, 2), "after half a turn");
        await complete(host, { action: "left 90" }, { action: "left 90" });
      },
    },
    {
      promise: "turn-left",
      name: "left 90 turns a quarter to the left",
      run: async (host) => turns(host, [{ action: "left 90" }], -1),
    },
    {
      promise: "turn-right",
      name: "right 90 turns a quarter to the right",
      run: async (host) => turns(host, [{ action: "right 90" }], 1),
    },
    {
      promise: "turn-half",
      name: "turn 180 turns by 180 degrees",
      run: async (host) => turns(host, [{ action: "turn 180" }], 2),
    },
    {
      promise: "turn-whole",
      name: "four quarter turns, or two half turns, are a full turn",
      run: async (host) => {
        await moveToStart(host);
        for (const [times, action] of [
          [4, "left 90"],
          [4, "right 90"],
          [2, "turn 180"],
        ] as const) {
          await complete(host, ...Array.from({ length: times }, () => ({ action })));
          await mustHaveReadings(host, START_READINGS, `after ${times} times ${action}`);
        }
      },
    },
    {
      promise: "turn-degrees",
      name: "turn takes degrees: above 0 to the right, below 0 to the left",
      run: async (host) => {
        await turns(host, [{ action: "turn", degrees: 90 }], 1);
        await turns(host, [{ action: "turn", degrees: -90 }], -1);
        await turns(host, [{ action: "turn", degrees: 360 }], 0);
      },
    },
    {
      promise: "move-distance",
      name: "move drives forward by its distance in cm",
      run: async (host) => {
        const { sensors } = await moveToStart(host);
        await complete(host, { action: "move", distance: 50 });
        await mustHaveMoved(host, sensors, 50);
      },
    },
    {
      promise: "move-backward",
      name: "a move below 0 drives backward",
      run: async (host) => {
        await complete(host, { action: "move", distance: 50 });
        const before = await readings(host);
        await complete(host, { action: "move", distance: -50 });
        await mustHaveMoved(host, before, -50);
      },
    },
    {
      promise: "record-distance",
      name: "a record contains the cm driven by its command, 0 or more",
      run: async (host) => {
        await moveToStart(host);
        for (const distance of [60, -60]) {
          const [move] = await complete(host, { action: "move", distance });
          must(isNear(move?.distance ?? -1, 60), "a distance of about 60", move);
        }
        const [turn] = await complete(host, { action: "left 90" }, { action: "right 90" });
        must((turn?.distance ?? -1) < 10, "a distance of about 0 for a turn", turn);
      },
    },
    {
      promise: "milliseconds",
      name: "drive durationOf for its milliseconds",
      run: async (host) => {
        const startedAt = performance.now();
        const order = { action: "drive", left: 0, right: 0, milliseconds: DRIVE_MS } as const;
        await complete(host, order);
        const duration = performance.now() - startedAt;
        // A slow network can lengthen the measured time, but not shorten it.
        const isExpected = duration > 0.9 * DRIVE_MS && duration < 3 * DRIVE_MS;
        must(isExpected, `about ${DRIVE_MS} ms`, `${Math.round(duration)} ms`);
      },
    },
    {
      promise: "wheels",
      name: "drive sets the wheel powers: both positive is forward, more power on the left turns right",
      run: async (host) => {
        const { sensors } = await moveToStart(host);
        await complete(host, { action: "drive", left: 0.1, right: 0.1, milliseconds: 1_000 });
        const ahead = (await readings(host)).front;
        must(ahead < sensors.front - 3, `less than ${Math.round(sensors.front)} in front`, ahead);
        await moveToStart(host);
        const times = await wheelTurnsToTheRight(host);
        for (let n = 0; n < times; n++) await wheelTurn(host, -0.1);
      },
    },
    {
      promise: "forward-reverse",
      name: "forward drives forward and reverse backward, until the next command",
      run: async (host) => {
        const { sensors } = await moveToStart(host);
        await host.send({ action: "forward" });
        const { sensors: reached } = await whenFront(
          host,
          (front) => front < sensors.front - 60,
          "below",
        );
        await host.sendAndWait({ action: "stop" });
        await host.send({ action: "reverse" });
        await whenFront(host, (front) => front > reached.front + 30, "above");
        await host.sendAndWait({ action: "stop" });
        await moveToStart(host);
      },
    },
    {
      promise: "collision",
      name: "a wall ends a move as collided, and the same distance leads back",
      needs: ["bumps"],
      run: async (host) => {
        const before = await moveToStart(host);
        await complete(host, { action: "right 90" });
        const move = await host.sendAndWait({ action: "move", distance: TO_THE_WALL });
        must(move.state === "collided", "collided", move);
        const distance = move.distance ?? -1;
        must(distance > 0 && distance < 50, "a distance from 0 to 50", distance);
        const touching = await host.snapshot();
        must(touching.bumps === before.bumps + 1, `bumps ${before.bumps + 1}`, touching.bumps);
        must(touching.bumping, "bumping: true at the wall", touching.bumping);
        await complete(host, { action: "move", distance: -distance });
        const later = await host.snapshot();
        must(!later.bumping, "bumping: false away from the wall", later.bumping);
        await mustHaveReadings(host, turned(START_READINGS, 1), "after the same distance back");
        await complete(host, { action: "left 90" });
      },
    },
    {
      promise: "collision-forward",
      name: "a wall ends forward as collided too",
      needs: ["bumps"],
      run: async (host) => {
        await moveToStart(host);
        await complete(host, { action: "right 90" });
        const forward = await host.sendAndWait({ action: "forward" });
        must(forward.state === "collided", "collided", forward);
        await complete(host, { action: "move", distance: -(forward.distance ?? 0) });
        await mustHaveReadings(host, turned(START_READINGS, 1), "after the same distance back");
        await complete(host, { action: "left 90" });
      },
    },
    {
      promise: "delayed-turns",
      name: "a delayed turn drives 50 cm, turns, and drives 60 cm",
      run: async (host) => {
        await moveToStart(host);
        await complete(host, { action: "delayed left 90" });
        await mustHaveReadings(
          host,
          { front: 90, right: 400, back: 110, left: 100 },
          "after delayed left 90",
        );
        await complete(host, { action: "move", distance: -60 }, { action: "right 90" });
        await complete(host, { action: "move", distance: -50 }, { action: "left 90" });
        await mustHaveReadings(
          host,
          turned(START_READINGS, -1),
          "back at its place, looking to the left",
        );
        await complete(host, { action: "delayed right 90" });
        await mustHaveReadings(
          host,
          { front: 390, right: 100, back: 110, left: 100 },
          "after delayed right 90",
        );
        await complete(host, { action: "move", distance: -60 }, { action: "left 90" });
        await complete(host, { action: "move", distance: -50 }, { action: "right 90" });
        await moveToStart(host);
      },
    },
    {
      promise: "delayed-wall",
      name: "a wall ends one part of a delayed turn, and the next part follows",
      needs: ["bumps"],
      run: async (host) => {
        await moveToStart(host);
        await complete(host, { action: "right 90" });
        const turn = await host.sendAndWait({ action: "delayed left 90" });
        must(turn.state === "collided", "collided", turn);
        const expected = { front: 390, right: 25, back: 110, left: 175 };
        await mustHaveReadings(host, expected, "after delayed left 90 against the right wall");
        await complete(host, { action: "move", distance: -60 }, { action: "right 90" });
        await complete(host, { action: "move", distance: -25 }, { action: "left 90" });
        await moveToStart(host);
      },
    },
    {
      promise: "speed",
      name: "forward drives 100 cm/s, and drive at power 0.2 turns a quarter in 0.6 s",
      needs: ["speed"],
      run: async (host) => {
        const speeds: number[] = [];
        const isExpected = (speed: number) => speed > 50 && speed < 200;
        // A busy computer can slow down one attempt, but hardly all three.
        while (!speeds.some(isExpected) && speeds.length < 3) speeds.push(await forwardSpeed(host));
        const found = `${speeds.map((speed) => Math.round(speed)).join(", ")} cm/s`;
        must(speeds.some(isExpected), "about 100 cm/s", found);
        await moveToStart(host);
        await turns(host, [{ action: "drive", left: 0.2, right: -0.2, milliseconds: 600 }], 1);
      },
    },
    {
      promise: "goal",
      name: "goalReached becomes true at the goal, and stays true",
      needs: ["goal"],
      run: async (host) => {
        await moveToStart(host);
        await complete(host, { action: "move", distance: 400 });
        const { goalReached } = await host.snapshot();
        must(goalReached, "goalReached: true in the far right corner", goalReached);
        const later = await moveToStart(host);
        must(later.goalReached, "goalReached: true afterwards", later.goalReached);
      },
    },
  ],
};

/** Sends commands one by one. @throws Mismatch unless each ends as completed */
async function complete(host: Host, ...orders: Order[]): Promise<CommandRecord[]> {
  const records: CommandRecord[] = [];
  for (const order of orders) {
    const record = await host.sendAndWait(order);
    must(record.state === "completed", `${order.action} to end as completed`, record);
    records.push(record);
  }
  return records;
}

/** Sends commands, checks the readings after them, and turns back by quarter turns to the left. */
async function turns(host: Host, orders: Order[], quarters: number): Promise<void> {
  await moveToStart(host);
  await complete(host, ...orders);
  const after = orders.map((order) => JSON.stringify(order)).join(", ");
  await mustHaveReadings(host, turned(START_READINGS, quarters), `after ${after}`);
  const back = ((quarters % 4) + 4) % 4;
  await complete(host, ...Array.from({ length: back }, () => ({ action: "left 90" as const })));
}

async function mustHaveMoved(host: Host, from: SensorReadings, distance: number): Promise<void> {
  const now = await readings(host);
  must(
    isNear(from.front - now.front, distance) && isNear(now.back - from.back, distance),
    `${distance} cm further ahead than ${show(from)}: about ${show(moved(from, distance))}`,
    show(now),
  );
}

async function wheelTurn(host: Host, power: number): Promise<void> {
  await complete(host, { action: "drive", left: power, right: -power, milliseconds: 300 });
}

/** Turns by the wheels until the robot faces right. @returns the number of turns */
async function wheelTurnsToTheRight(host: Host): Promise<number> {
  for (let times = 1; times <= MAX_WHEEL_TURNS; times++) {
    await wheelTurn(host, 0.1);
    const now = await readings(host);
    const isExpected = areNear(now, turned(START_READINGS, 1));
    const isLeft = areNear(now, turned(START_READINGS, -1));
    must(!isLeft, "a turn to the right by the left wheel", show(now));
    if (isExpected) return times;
  }
  throw new Mismatch("a quarter turn to the right by the wheels", show(await readings(host)));
}

/** @returns the speed in cm/s */
async function forwardSpeed(host: Host): Promise<number> {
  await moveToStart(host);
  await host.send({ action: "forward" });
  const first = await whenFront(host, (front) => front < START_READINGS.front - 20, "below");
  const last = await whenFront(host, (front) => front < first.sensors.front - 60, "below");
  await host.sendAndWait({ action: "stop" });
  return (first.sensors.front - last.sensors.front) / ((last.tick - first.tick) / TICKS_PER_SECOND);
}

/** Waits for a reading of the front sensor. @returns its snapshot */
async function whenFront(
  host: Host,
  isThere: (front: number) => boolean,
  what: string,
): Promise<Snapshot> {
  let snapshot = await host.snapshot();
  const before = snapshot.sensors.front;
  const deadline = performance.now() + 8_000;
  while (!isThere(snapshot.sensors.front)) {
    must(
      performance.now() < deadline,
      `a reading in front ${what} ${Math.round(before)}`,
      snapshot,
    );
    snapshot = await host.snapshot(`?after=${snapshot.seq}&wait=2`);
  }
  return snapshot;
}
