import { describe, expect, it } from "vitest";
import {
  conditionsEndAt,
  GUARDED_RECORDS,
  isSameCommand,
  shorten,
  shownRecordIn,
  toShorten,
} from "./stored-conditions.ts";
import { robotWith, rowOf } from "./testing/robot-with.ts";

const FORWARD = '{"action":"forward","until":[{"sensor":"front","is":"<=","than":60}]}';
const OTHER = '{"action":"forward","until":[{"sensor":"front","is":"<=","than":61}]}';

const endedRow = (seq: number) => rowOf({ seq, text: FORWARD, state: "completed" });

describe("the conditions of ended commands", () => {
  it.each([
    { name: "no command is open", open: [], end: 300 },
    { name: "the newest are open", open: [499, 500], end: 298 },
    { name: "old ones are open", open: [1, 300], end: 300 },
    { name: "one at the limit is open", open: [301, 500], end: 298 },
  ])("are shown for the newest 200 if $name", ({ open, end }) => {
    expect(conditionsEndAt(500, open)).toBe(end);
    const all = Array.from({ length: 500 }, (_, index) => index + 1);
    const shown = all.filter((seq) => seq > end && !(open as number[]).includes(seq));
    expect(shown).toHaveLength(GUARDED_RECORDS);
  });

  it("are no longer stored some commands later, and the command is still compared with them", () => {
    const rows = Array.from({ length: 299 }, (_, index) => endedRow(index + 1));
    const open = rowOf({ seq: 50, text: FORWARD, state: "started" });
    rows[49] = open;
    const robot = robotWith(rows);
    const range = toShorten(robot);
    expect(range).toEqual({ after: -1, upTo: 99 });
    shorten(
      robot,
      rows.slice(0, 99).filter(({ state }) => state === "completed"),
    );
    const [first, last] = [robot.row(1), robot.row(100)];
    if (first === null || last === null) throw new Error("deleted");
    expect(first.text).not.toContain("sensor");
    expect(shownRecordIn(robot, first)).toMatchObject({ command: { action: "forward" } });
    expect(shownRecordIn(robot, first).command).toEqual({ action: "forward" });
    for (const row of [open, last]) {
      expect(shownRecordIn(robot, row).command).toEqual(JSON.parse(FORWARD));
    }
    for (const row of [first, last]) {
      expect(isSameCommand(row, FORWARD)).toBe(true);
      expect(isSameCommand(row, OTHER)).toBe(false);
      expect(isSameCommand(row, '{"action":"forward"}')).toBe(false);
    }
  });

  it("are looked at with every fiftieth command", () => {
    expect(toShorten(robotWith(Array.from({ length: 300 }, (_, n) => endedRow(n + 1))))).toBeNull();
  });
});
