import { expect, it } from "vitest";
import { holds, reportOf, type Judged } from "./report.ts";

const about = {
  date: "2026-01-02",
  machine: "a machine",
  versions: "Node 26",
  isLong: false,
  seed: 1,
};

function row(measured: number): Judged {
  const goal = { label: "back", measured, bound: { atMost: 2 }, unit: "s" };
  return { title: "Killed", does: "kills it", goals: [goal], seconds: 61, load: 1 };
}

it("a row holds when all of its goals are met, and it came to its end", () => {
  expect(holds(row(2))).toBe(true);
  expect(holds(row(2.1))).toBe(false);
  expect(holds({ ...row(1), goals: null, fault: "no relay" })).toBe(false);
});

it("says of every row what must hold, what was measured and whether it holds", () => {
  const broken: Judged = {
    title: "Broken",
    does: "falls",
    goals: null,
    fault: "a | b",
    seconds: 1,
    load: 1,
  };
  const report = reportOf([row(1.5), row(3), broken], about);
  expect(report).toContain("| Killed | back: at most 2 | 1.5 s | pass |");
  expect(report).toContain("| Killed | back: at most 2 | 3 s | FAIL |");
  expect(report).toContain("| Broken | runs to its end | a \\| b | FAIL |");
  expect(report).toContain("1 of 3 rows hold");
});
