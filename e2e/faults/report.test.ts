import { expect, it } from "vitest";
import { passes, reportOf, type Result } from "./report.ts";

const about = {
  date: "2026-01-02",
  machine: "a machine",
  versions: "Node 26",
  isLong: false,
  seed: 1,
};

function scenario(measured: number): Result {
  const goal = { label: "back", measured, bound: { atMost: 2 }, unit: "s" };
  return { title: "Killed", description: "kills it", goals: [goal], seconds: 61, load: 1 };
}

it("passes a scenario when it ran to its end and met all goals", () => {
  expect(passes(scenario(2))).toBe(true);
  expect(passes(scenario(2.1))).toBe(false);
  expect(passes({ ...scenario(1), goals: null, fault: "no relay" })).toBe(false);
});

it("reports each goal, its measured value and its verdict", () => {
  const broken: Result = {
    title: "Broken",
    description: "falls",
    goals: null,
    fault: "a | b",
    seconds: 1,
    load: 1,
  };
  const report = reportOf([scenario(1.5), scenario(3), broken], about);
  expect(report).toContain("| Killed | back: at most 2 | 1.5 s | pass |");
  expect(report).toContain("| Killed | back: at most 2 | 3 s | FAIL |");
  expect(report).toContain("| Broken | runs to its end | a \\| b | FAIL |");
  expect(report).toContain("1 of 3 scenarios pass");
});

it("reports equal counts of several faults in one row", () => {
  const counts = { lost: 0, doubled: 0, reordered: 2, "ended twice": 0, late: 0 };
  const goals = Object.entries(counts).map(([kind, measured]) => ({
    label: `commands ${kind}`,
    measured,
    bound: { atMost: 0 },
    unit: "of 9",
  }));
  const report = reportOf([{ ...scenario(1), goals }], about);
  expect(report).toContain("| Killed | commands lost, doubled: at most 0 | 0 of 9 | pass |");
  expect(report).toContain("|  | commands reordered: at most 0 | 2 of 9 | FAIL |");
  expect(report).toContain("|  | commands ended twice, late: at most 0 | 0 of 9 | pass |");
});
