import { CommandLog } from "@corridor/recording";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { commandMarksOf, commandUnder } from "./command-marks.ts";
import { scaleOf } from "./time-scale.ts";

const width = 480;

/**
 * A log of commands: the ticks of each, its final state, and the ticks for which the robot waits
 * before it.
 */
function logOf(...commands: [number, "completed" | "collided" | "cancelled" | null, number?][]) {
  const log = new CommandLog();
  let tick = 0;
  for (const [index, [ticks, ending, wait = 0]] of commands.entries()) {
    tick += wait;
    log.recordStart(index + 1, { action: "forward" }, tick);
    tick += ticks;
    if (ending !== null) log.recordEnd(tick, ending);
  }
  return { log, end: tick };
}

function marksOf({ log, end }: ReturnType<typeof logOf>) {
  return commandMarksOf(log, scaleOf(end, width), end);
}

describe("the commands of a script on the ribbon", () => {
  it("have their numbers and results where they ran", () => {
    const marks = marksOf(
      logOf([300, "completed"], [300, "collided", 150], [300, "cancelled"], [150, null]),
    );
    expect(marks.map(({ label, x, width: wide, result }) => [label, x, wide, result])).toEqual([
      ["1", 0, 79, "done"],
      ["2", 120, 79, "collided"],
      ["3", 200, 79, "ended"],
      ["4", 280, 39, "running"],
    ]);
  });

  it("are one mark where they lie too close, with the worst result", () => {
    const marks = marksOf(
      logOf(
        [300, "completed"],
        [10, "completed"],
        [10, "collided"],
        [10, "completed"],
        [300, null],
      ),
    );
    expect(marks.map(({ label, result }) => [label, result])).toEqual([
      ["1", "done"],
      ["2–5", "collided"],
    ]);
  });

  it("are found by the pointer on their number", () => {
    const marks = marksOf(logOf([300, "completed"], [300, "completed"]));
    expect(commandUnder(marks, 82)?.tick).toBe(300);
    expect(commandUnder(marks, 120)).toBeNull();
  });

  it("of any script never lie one over another, and none is left out", () => {
    const anyCommand = fc.tuple(
      fc.integer({ min: 0, max: 400 }),
      fc.constant("completed" as const),
      fc.integer({ min: 0, max: 400 }),
    );
    fc.assert(
      fc.property(fc.array(anyCommand, { maxLength: 300 }), (commands) => {
        const marks = marksOf(logOf(...commands));
        let next = 1;
        for (const [index, { label, x, pressWidth }] of marks.entries()) {
          const [first, last = first] = label.split("–").map(Number);
          expect(first).toBe(next);
          next = (last ?? 0) + 1;
          const after = marks[index + 1]?.x ?? Infinity;
          expect(x + pressWidth).toBeLessThanOrEqual(after + 1);
        }
        expect(next).toBe(commands.length + 1);
      }),
    );
  });
});
