import { describe, expect, it } from "vitest";
import { seenStudent } from "./testing/seen-student.ts";
import { summaryOf } from "./class-summary.ts";
import { standings, type Standing } from "./standing.ts";
import {
  filters,
  groupedStudent,
  groupOf,
  isIn,
  notHere,
  type Filter,
  type GroupedStudent,
} from "./student-group.ts";
import type { Verification, Verifications } from "./verifier.ts";

const claim = { code: "a", activeAt: 60_000, lines: 2, attempts: 1 };
const passed: Verification = { kind: "passes", claim, attempt: [] };
const inTask: GroupedStudent = { ...notHere, standing: "working", isInTask: true };

/** A class in which students do different things, and students 1 and 2 have solved task 1. */
function classOf(...doing: readonly { standing: Standing; task: number }[]) {
  const students = new Map(
    doing.map(({ task }, at) => {
      const tile = { task, state: "writing", line: null } as const;
      return [at + 1, seenStudent(at + 1, { tile })];
    }),
  );
  const shown = new Map(doing.map(({ standing }, at) => [at + 1, { standing }]));
  const verifications: Verifications = new Map([
    [1, new Map([[1, passed]])],
    [2, new Map([[1, passed]])],
  ]);
  return { students, shown, verifications };
}

describe("the filter of the cards", () => {
  it("has as many students as the results, also while students work on other tasks", () => {
    const { students, shown, verifications } = classOf(
      { standing: "working", task: 2 },
      { standing: "solved", task: 1 },
      { standing: "bumped", task: 1 },
      { standing: "bumped", task: 2 },
      { standing: "disconnected", task: 1 },
    );
    for (const task of [1, 2]) {
      const now = { shown, verifications, isPaused: false };
      const settings = { expected: 6, isPaused: false };
      const { solved, all, groups } = summaryOf(task, students, shown, verifications, settings);
      const grouped = [...students.values()].map((each) => groupedStudent(each, task, now));
      const inFilter = (filter: Filter) =>
        [...grouped, notHere].filter((each) => isIn(filter, each)).length;
      expect([solved, inFilter("solved")]).toEqual(task === 1 ? [2, 2] : [0, 0]);
      expect(inFilter("working")).toBe(groups.driving + groups.writing + groups.bumped);
      expect([groups.bumped, inFilter("working")]).toEqual(task === 1 ? [1, 1] : [1, 2]);
      expect([groups.elsewhere, inFilter("elsewhere")]).toEqual(task === 1 ? [1, 1] : [2, 2]);
      expect([groups.away, inFilter("away")]).toEqual([2, 2]);
      expect(inFilter("all")).toBe(all);
      expect(Object.values(groups).reduce((sum, count) => sum + count)).toBe(all);
    }
  });

  it("finds a student who needs help, also in another task than that of the results", () => {
    const stuck: GroupedStudent = { ...inTask, standing: "stuck" };
    expect(isIn("help", { ...stuck, isSolved: true })).toBe(true);
    expect(groupOf({ ...stuck, isSolved: true })).toBe("solved");
    expect(isIn("help", { ...stuck, isInTask: false })).toBe(true);
    expect(groupOf({ ...stuck, isInTask: false })).toBe("elsewhere");
  });

  it("shows every student in at least one filter besides all", () => {
    const others = filters.filter((each) => each !== "all");
    for (const standing of standings) {
      for (const isSolved of [true, false]) {
        for (const isInTask of [true, false]) {
          const student = { ...inTask, standing, isSolved, isInTask };
          expect(others.some((filter) => isIn(filter, student))).toBe(true);
        }
      }
    }
  });
});

describe("a group of the results", () => {
  it.each([
    { what: "writes", change: {}, group: "writing" },
    { what: "drives", change: { isDriving: true }, group: "driving" },
    { what: "waits in a pause", change: { isPaused: true, isDriving: true }, group: "paused" },
    { what: "is stuck", change: { standing: "stuck" }, group: "stuck" },
    {
      what: "asked for help in a pause",
      change: { standing: "help", isPaused: true },
      group: "help",
    },
    { what: "has another task open", change: { isInTask: false }, group: "elsewhere" },
  ] as const)("has a student who $what: $group", ({ change, group }) => {
    expect(groupOf({ ...inTask, ...change })).toBe(group);
  });
});
