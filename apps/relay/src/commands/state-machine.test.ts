import { commandRecordSchema, hasEnded, type CommandState } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { RobotCommands } from "./robot-commands.ts";
import * as pages from "./page-transitions.ts";
import * as machine from "./state-machine.ts";
import type { NewCommand, PageState } from "./robot-step.ts";
import {
  DRIVER,
  endingOf,
  EPOCH,
  newCommand,
  NOW,
  pageWith,
  robotWith,
  rowOf,
  statesOf,
  STOP,
} from "./testing/robot-with.ts";

const commandStates = commandRecordSchema.shape.state.options;
const endingStates = commandStates.filter(hasEnded);
const none = (): null => null;
const acquire = (robot: RobotCommands, page: Partial<PageState>) =>
  pages.acquire(robot, pageWith(page), {
    row: (seq) => robot.row(seq),
    newest: (what, after) => pages.newestOvertaking(robot.rows(), what, after),
  });
const end = (robot: RobotCommands, epoch: number, state: "completed" | "collided" = "completed") =>
  machine.end(robot, epoch, endingOf(1, state), (seq) => robot.row(seq));

type Next = CommandState | "-";
/**
 * Every event that may change command 1, and its state afterwards if it was accepted, delivered or
 * started before. "-": unchanged.
 */
const events: Record<
  string,
  [happens: (robot: RobotCommands) => unknown, next: [Next, Next, Next]]
> = {
  "it is delivered to the page": [
    (robot) => machine.deliver(robot, { epoch: EPOCH, window: 8, now: NOW }),
    ["delivered", "-", "-"],
  ],
  "it is delivered to an earlier page": [
    (robot) => machine.deliver(robot, { epoch: EPOCH - 1, window: 8, now: NOW }),
    ["-", "-", "-"],
  ],
  "its deadline passes": [(robot) => machine.expire(robot, NOW + 10_000), ["expired", "-", "-"]],
  "its sender cancels it": [
    (robot) => machine.cancel(robot, robot.row(1), DRIVER),
    ["cancelled", "-", "-"],
  ],
  "another sender cancels it": [
    (robot) => machine.cancel(robot, robot.row(1), "another"),
    ["-", "-", "-"],
  ],
  "its key is revoked": [
    (robot) => machine.recallAllOf(robot, { driver: DRIVER }, "revoked"),
    ["cancelled", "-", "-"],
  ],
  "remote driving is paused": [(robot) => machine.pause(robot, true), ["cancelled", "-", "-"]],
  "a stop arrives": [
    (robot) => machine.add(robot, newCommand({ command: { action: "stop" } }), none),
    ["cancelled", "-", "-"],
  ],
  "a replacing command arrives": [
    (robot) => machine.add(robot, newCommand({ replace: true }), none),
    ["superseded", "-", "-"],
  ],
  "another command arrives": [(robot) => machine.add(robot, newCommand(), none), ["-", "-", "-"]],
  "the page starts it": [(robot) => machine.start(robot, EPOCH, 1), ["-", "started", "-"]],
  "an earlier page starts it": [(robot) => machine.start(robot, EPOCH - 1, 1), ["-", "-", "-"]],
  "the page completes it": [(robot) => end(robot, EPOCH), ["-", "completed", "completed"]],
  "an earlier page completes it": [(robot) => end(robot, EPOCH - 1), ["-", "-", "-"]],
  "the page is considered lost": [
    (robot) => pages.abandon(robot, EPOCH),
    ["-", "cancelled", "cancelled"],
  ],
  "an earlier page is considered lost": [
    (robot) => pages.abandon(robot, EPOCH - 1),
    ["-", "-", "-"],
  ],
  "the page reconnects without it": [(robot) => acquire(robot, {}), ["-", "accepted", "-"]],
  "the page reconnects with it": [
    (robot) => acquire(robot, { lastApplied: 1 }),
    ["-", "started", "-"],
  ],
  "the page reconnects and has completed it": [
    (robot) => acquire(robot, { lastApplied: 1, endings: [endingOf(1)] }),
    ["-", "completed", "completed"],
  ],
  "the page was reloaded without it": [
    (robot) => acquire(robot, { fresh: true }),
    ["-", "accepted", "cancelled"],
  ],
  "the page was reloaded with it": [
    (robot) => acquire(robot, { fresh: true, lastApplied: 1 }),
    ["-", "cancelled", "cancelled"],
  ],
  "another page connects": [
    (robot) => acquire(robot, { knownEpoch: null, left: "taken-over" }),
    ["-", "cancelled", "cancelled"],
  ],
};

describe("a command", () => {
  const cases = Object.entries(events).flatMap(([event, [happens, states]]) =>
    commandStates.map((before, at) => {
      const next = states[at] ?? "-";
      return { event, happens, before, after: next === "-" ? before : next };
    }),
  );

  it.each(cases)("that is $before is $after when $event", ({ happens, before, after }) => {
    const robot = robotWith([rowOf({ state: before })]);
    happens(robot);
    expect(robot.row(1)?.state).toBe(after);
  });

  it.each(endingStates)("that is %s never changes", (state) => {
    const row = rowOf({ state, reason: "first", pose: null, distance: 5 });
    const robot = robotWith([row], (changed) => expect(changed).not.toBe(row));
    const before = { ...row };
    for (const [happens] of Object.values(events)) happens(robot);
    expect(row).toEqual(before);
  });

  it("that was delivered is marked by the first request to end it, and not delivered again", () => {
    const robot = robotWith([rowOf({ state: "delivered" })]);
    machine.cancel(robot, robot.row(1), DRIVER);
    machine.recallAllOf(robot, "all", "paused");
    expect(machine.recalled(robot.open)).toEqual([{ seq: 1, cause: "sender" }]);
    acquire(robot, {});
    expect(robot.row(1)).toMatchObject({ state: "cancelled", reason: { cause: "sender" } });
  });

  it("that was accepted in the future expires, because the clock was set back", () => {
    const robot = robotWith([rowOf({ acceptedAt: NOW + 2_001 })]);
    expect(machine.deliver(robot, { epoch: EPOCH, window: 8, now: NOW })).toEqual([]);
    expect(machine.expire(robot, NOW).ended).toMatchObject([{ record: { state: "expired" } }]);
  });
});

describe("a new command", () => {
  it.each([
    { name: "of an unknown key", change: { driver: "another" }, outcome: "revoked" },
    { name: "of a blocked script", change: { script: "blocked" }, outcome: "blocked" },
    { name: "after its deadline", change: { deadline: NOW }, outcome: "late" },
    { name: "beyond the limit", change: { maxWaiting: 1 }, outcome: "full" },
    {
      name: "that replaces, beyond the limit",
      change: { maxWaiting: 1, replace: true },
      outcome: "stored",
    },
  ])("$name is $outcome", ({ change, outcome }) => {
    const robot = robotWith([rowOf()]);
    robot.admissionState.blocked = new Set(["blocked"]);
    expect(machine.add(robot, newCommand(change), none)).toMatchObject({ outcome });
  });

  it("with a known idempotency key is a duplicate, even if it would be rejected otherwise", () => {
    const earlier = rowOf({ state: "completed", key: "key-0001" });
    const robot = robotWith([earlier]);
    robot.admissionState.isPaused = true;
    const again = newCommand({ key: "key-0001", deadline: NOW, maxWaiting: 0 });
    expect(machine.add(robot, again, () => earlier)).toMatchObject({
      outcome: "duplicate",
      record: { seq: 1, state: "completed" },
    });
    const other = { ...again, command: { action: "right 90" } as const };
    expect(machine.add(robot, other, () => earlier)).toMatchObject({ outcome: "conflict" });
  });

  it("is rejected while remote driving is paused, unless it is a stop", () => {
    const robot = robotWith([]);
    robot.admissionState.isPaused = true;
    expect(machine.add(robot, newCommand(), none)).toEqual({ outcome: "paused" });
    const stop = newCommand({ command: { action: "stop" }, maxWaiting: 0 });
    expect(machine.add(robot, stop, none)).toMatchObject({ outcome: "stored" });
  });
});

describe("a new reset", () => {
  const reset = (change: Partial<NewCommand> = {}) =>
    newCommand({ command: { action: "reset" }, ...change });

  it("supersedes all waiting commands, and does not wait for the robot's free places", () => {
    const robot = robotWith([rowOf({ seq: 1, state: "started" }), rowOf({ seq: 2 })]);
    expect(machine.add(robot, reset({ maxWaiting: 1 }), none)).toMatchObject({
      outcome: "stored",
      record: { seq: 3, action: "reset" },
      ended: [
        { record: { seq: 2, state: "superseded", reason: "Command 3 replaced this command." } },
      ],
    });
    machine.deliver(robot, { epoch: EPOCH, window: 1, now: NOW });
    expect(statesOf(robot).at(-1)).toEqual([3, "delivered"]);
  });

  it("is rejected too soon after another one, or while the owner forbids it, and ends nothing", () => {
    const robot = robotWith([rowOf()]);
    expect(machine.add(robot, reset({ resetFrom: NOW + 1 }), none)).toEqual({
      outcome: "too-soon",
    });
    robot.admissionState.mayReset = false;
    expect(machine.add(robot, reset(), none)).toEqual({ outcome: "reset-disabled" });
    expect(statesOf(robot)).toEqual([[1, "accepted"]]);
    expect(machine.add(robot, newCommand(), none)).toMatchObject({ outcome: "stored" });
  });

  it("with a known idempotency key returns its record, however soon it follows", () => {
    const text = '{"action":"reset"}';
    const robot = robotWith([rowOf({ key: "key-0001", text })]);
    const [earlier] = robot.rows();
    const again = reset({ key: "key-0001", resetFrom: NOW + 1 });
    expect(machine.add(robot, again, () => earlier ?? null)).toMatchObject({
      outcome: "duplicate",
    });
  });
});

describe("delivery", () => {
  it("fills the window in order; stops and replacing commands may exceed it", () => {
    const robot = robotWith([
      rowOf({ seq: 1, state: "delivered" }),
      rowOf({ seq: 2 }),
      rowOf({ seq: 3 }),
      rowOf({ seq: 4, replace: true }),
      rowOf({ seq: 5, text: STOP }),
    ]);
    machine.deliver(robot, { epoch: EPOCH, window: 2, now: NOW });
    expect(statesOf(robot)).toEqual([
      [1, "delivered"],
      [2, "delivered"],
      [3, "accepted"],
      [4, "delivered"],
      [5, "delivered"],
    ]);
    expect(robot.isWindowFull(2)).toBe(true);
  });

  it("fills the window behind a command that replaces", () => {
    const robot = robotWith([
      rowOf({ seq: 1, replace: true }),
      rowOf({ seq: 2 }),
      rowOf({ seq: 3 }),
    ]);
    const due = machine.deliver(robot, { epoch: EPOCH, window: 2, now: NOW });
    expect(due.map(({ record }) => record.seq)).toEqual([1, 2, 3]);
  });
});

describe("a page that acquires the robot", () => {
  it("receives no command that a stop or a replacement has overtaken, even if that one has ended", () => {
    const robot = robotWith([
      rowOf({ seq: 1, state: "delivered" }),
      rowOf({ seq: 2, replace: true, state: "completed" }),
      rowOf({ seq: 3 }),
    ]);
    acquire(robot, {});
    expect(statesOf(robot)).toEqual([
      [1, "superseded"],
      [2, "completed"],
      [3, "accepted"],
    ]);
  });

  it("raises the epoch, so that reports of the previous page are ignored", () => {
    const robot = robotWith([rowOf({ state: "delivered" })]);
    expect(acquire(robot, { lastApplied: 1 })).toMatchObject({ epoch: EPOCH + 1 });
    expect(end(robot, EPOCH)).toMatchObject({ outcome: "over", record: { state: "started" } });
  });

  it("receives the list of its endings that came too late", () => {
    const robot = robotWith([rowOf({ state: "cancelled" })]);
    const { refused } = acquire(robot, { lastApplied: 1, endings: [endingOf(1)] });
    expect(refused).toMatchObject([{ seq: 1, state: "cancelled" }]);
    const same = acquire(robot, { lastApplied: 1, endings: [endingOf(1, "cancelled")] });
    expect(same.refused).toEqual([]);
  });
});
