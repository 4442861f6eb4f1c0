import { describe, expect, it } from "vitest";
import { LastProblem } from "./last-problem.ts";

describe("the last problem of a script", () => {
  it("changes at most once a second, and ends with the newest", () => {
    const problem = new LastProblem();
    expect(problem.at(0)).toBeNull();
    problem.record("First.", 10_000);
    problem.record("Second.", 10_400);
    problem.record("Third.", 10_900);
    expect(problem.at(10_999)?.detail).toBe("First.");
    expect(problem.isPending).toBe(true);
    expect(problem.at(11_000)).toEqual({ detail: "Third.", at: "1970-01-01T00:00:10.900Z" });
    expect(problem.isPending).toBe(false);
    problem.record("Fourth.", 11_500);
    expect(problem.at(11_999)?.detail).toBe("Third.");
    expect(problem.at(20_000)?.detail).toBe("Fourth.");
  });

  it("is short enough for a message", () => {
    const problem = new LastProblem();
    problem.record("x".repeat(5_000), 0);
    expect(problem.at(0)?.detail).toMatch(/^x{249}…$/);
  });
});
