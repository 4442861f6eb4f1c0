/** What holds for a robot's commands after any events. */
import { hasEnded, type EndingState } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { CommandRow, RobotCommands } from "./robot-commands.ts";
import * as pages from "./page-transitions.ts";
import * as machine from "./state-machine.ts";
import { DRIVER, endingOf, newCommand, NOW, pageWith, robotWith } from "./testing/robot-with.ts";

type Event = (robot: RobotCommands) => unknown;

const WINDOW = 3;
const seqs = fc.integer({ min: 1, max: 12 });
const epochs = fc.integer({ min: 1, max: 3 });
const keys = fc.constantFrom("key-0001", "key-0002", "key-0003");
const withKey =
  (robot: RobotCommands) =>
  (driver: string, key: string): CommandRow | null =>
    robot.withKey(driver, key);

const arrival = fc
  .record({
    key: fc.option(keys),
    command: fc.constantFrom(
      { action: "left 90" } as const,
      { action: "forward" } as const,
      { action: "stop" } as const,
    ),
    replace: fc.boolean(),
    script: fc.constantFrom(null, "s"),
    maxWaiting: fc.constantFrom(2, 64),
  })
  .map(
    (given): Event =>
      (robot) =>
        machine.add(robot, newCommand(given), withKey(robot)),
  );
const report = fc.oneof(
  fc.tuple(epochs, fc.integer({ min: NOW, max: NOW + 11_000 })).map(
    ([epoch, now]): Event =>
      (robot) =>
        machine.deliver(robot, { epoch, now, window: WINDOW }),
  ),
  fc.tuple(epochs, seqs).map(
    ([epoch, seq]): Event =>
      (robot) =>
        machine.start(robot, epoch, seq),
  ),
  fc.tuple(epochs, seqs, fc.constantFrom<EndingState>("completed", "collided")).map(
    ([epoch, seq, state]): Event =>
      (robot) =>
        machine.end(robot, epoch, endingOf(seq, state), (known) => robot.row(known)),
  ),
);
const rare = fc.oneof(
  fc.integer({ min: NOW, max: NOW + 11_000 }).map(
    (now): Event =>
      (robot) =>
        machine.expire(robot, now),
  ),
  seqs.map(
    (seq): Event =>
      (robot) =>
        machine.cancel(robot, robot.row(seq), DRIVER),
  ),
  fc.constant<Event>((robot) => machine.recallAllOf(robot, { script: "s" }, "blocked")),
  fc.boolean().map(
    (isPaused): Event =>
      (robot) =>
        machine.pause(robot, isPaused),
  ),
  epochs.map(
    (epoch): Event =>
      (robot) =>
        pages.abandon(robot, epoch),
  ),
  fc
    .record({
      lastApplied: fc.integer({ min: 0, max: 12 }),
      fresh: fc.boolean(),
      knownEpoch: fc.option(fc.integer({ min: 0, max: 4 })),
      endings: fc.array(
        seqs.map((seq) => endingOf(seq)),
        { maxLength: 2 },
      ),
    })
    .map(
      (page): Event =>
        (robot) =>
          pages.acquire(robot, pageWith(page), {
            row: (seq) => robot.row(seq),
            newest: (what, after) => pages.newestOvertaking(robot.rows(), what, after),
          }),
    ),
);
const events = fc.array(
  fc.oneof(
    { weight: 4, arbitrary: arrival },
    { weight: 5, arbitrary: report },
    { weight: 2, arbitrary: rare },
  ),
  { maxLength: 60 },
);

/** Checks a robot after each event. */
function inEachState(check: (robot: RobotCommands) => void): void {
  fc.assert(
    fc.property(events, (all) => {
      const robot = robotWith([]);
      for (const happens of all) {
        happens(robot);
        check(robot);
      }
    }),
    { numRuns: 300 },
  );
}

describe("after any events", () => {
  it("an ended command has not changed, so the first ending has won", () => {
    fc.assert(
      fc.property(events, (all) => {
        const robot = robotWith([]);
        const ended = new Map<number, CommandRow>();
        for (const happens of all) {
          happens(robot);
          for (const row of robot.rows()) {
            expect(row).toEqual(ended.get(row.seq) ?? row);
            if (hasEnded(row.state)) ended.set(row.seq, { ...row });
          }
        }
      }),
      { numRuns: 300 },
    );
  });

  it("the page has at most a window of delivered commands, not counting those that may exceed it", () => {
    inEachState((robot) => {
      const delivered = [...robot.open].filter(({ state }) => state === "delivered");
      const counted = delivered.filter(({ overtakes }) => overtakes === null);
      expect(counted.length).toBeLessThanOrEqual(WINDOW);
      expect(robot.deliveredCount).toBe(counted.length);
    });
  });

  it("no idempotency key belongs to two commands", () => {
    inEachState((robot) => {
      const known = robot.rows().flatMap(({ key }) => key ?? []);
      expect(new Set(known).size).toBe(known.length);
      const rows = robot.rows().filter(({ key }) => key !== null);
      expect(rows.map(({ driver, key }) => robot.withKey(driver, key ?? ""))).toEqual(rows);
    });
  });

  it("commands are numbered without gaps, except where a page has seen later ones", () => {
    inEachState((robot) => {
      const numbers = robot.rows().map(({ seq }) => seq);
      expect(numbers).toEqual([...new Set(numbers)].toSorted((a, b) => a - b));
      expect(robot.admissionState.lastSeq).toBeGreaterThanOrEqual(numbers.at(-1) ?? 0);
    });
  });

  it("no command waits before a stop that arrived later", () => {
    inEachState((robot) => {
      const rows = robot.rows();
      const stop = pages.newestOvertaking(rows, "stop", 0) ?? 0;
      const isLeft = rows.some(({ seq, state }) => state === "accepted" && seq < stop);
      expect(isLeft).toBe(false);
    });
  });
});
