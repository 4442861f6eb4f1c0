import { describe, expect, it } from "vitest";
import { seenStudent } from "./testing/seen-student.ts";
import { summaryOf } from "./class-summary.ts";
import { standings, type Standing } from "./standing.ts";
import { filters, groupOf, hasSolved, isIn, type Filter } from "./student-group.ts";
import type { Verification, Verifications } from "./verifier.ts";

const claim = { code: "a", activeAt: 60_000, lines: 2, attempts: 1 };
const passed: Verification = { kind: "passes", claim, attempt: [] };

/** A class in which students do different things, and students 1 and 2 have solved task 1. */
function classOf(...shown: Standing[]) {
  const students = new Map(shown.map((_, at) => [at + 1, seenStudent(at + 1)]));
  const standing = new Map(shown.map((each, at) => [at + 1, { standing: each }]));
  const verifications: Verifications = new Map([
    [1, new Map([[1, passed]])],
    [2, new Map([[1, passed]])],
  ]);
  return { students, standing, verifications };
}

describe("the filter of the cards", () => {
  it("has as many solved students as the results, also while they work on the next task", () => {
    const { students, standing, verifications } = classOf("working", "solved", "solved", "bumped");
    for (const [task, solved] of [
      [1, 2],
      [2, 0],
    ] as const) {
      const summary = summaryOf(task, students, standing, verifications, null);
      const inFilter = (filter: Filter) =>
        [...standing].filter(([student, each]) =>
          isIn(filter, each.standing, hasSolved(verifications, student, task)),
        ).length;
      expect(summary.solved).toBe(solved);
      expect(inFilter("solved")).toBe(summary.solved);
      expect(inFilter("working")).toBe(summary.working + summary.bumped);
      expect(inFilter("all")).toBe(summary.all);
    }
  });

  it("finds a student who needs help, also after the task of the results was solved", () => {
    expect(isIn("help", "stuck", true)).toBe(true);
    expect(isIn("solved", "stuck", true)).toBe(true);
    expect(groupOf("stuck", true)).toBe("solved");
  });

  it("shows every student in at least one filter besides all", () => {
    const others = filters.filter((each) => each !== "all");
    for (const standing of standings) {
      for (const isSolved of [true, false]) {
        expect(others.some((filter) => isIn(filter, standing, isSolved))).toBe(true);
      }
    }
  });
});
