import type { LessonRow } from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import { isMet } from "./grade-lesson.ts";

function rows(passed: number, failed: number): LessonRow[] {
  const row = { program: "a", task: 1, code: null, maze: null, tick: null, lines: 0 };
  return [...Array(passed).fill(true), ...Array(failed).fill(false)].map((each: boolean) => ({
    ...row,
    passed: each,
    seconds: null,
    unseen: null,
  }));
}

describe("--require", () => {
  it.each([
    { passed: 0, failed: 3, required: null, met: true },
    { passed: 3, failed: 0, required: 100, met: true },
    { passed: 199, failed: 1, required: 100, met: false },
    { passed: 9, failed: 1, required: 90, met: true },
    { passed: 8, failed: 1, required: 90, met: false },
    { passed: 0, failed: 1, required: 1, met: false },
  ])("of $required %: $passed lines pass and $failed fail", ({ passed, failed, required, met }) => {
    expect(isMet(rows(passed, failed), required)).toBe(met);
  });
});
