import { describe, expect, it } from "vitest";
import { Score, type StatName } from "./score.ts";

function read(score: Score, ...names: StatName[]): string[] {
  return names.map((name) => score.get(name));
}

describe("the score", () => {
  it("has no best run before the goal", () => {
    const score = new Score();
    expect(
      read(score, "best-run-distance", "best-run-turns", "best-run-effective-distance"),
    ).toEqual(["-1", "-1", "-1"]);
    expect(read(score, "total-distance", "current-run-turns", "score")).toEqual(["0", "0", "2000"]);
  });

  it("counts cells beyond the second of a move half", () => {
    const score = new Score();
    score.begin();
    score.addMove(5);
    score.addMove(2);
    score.addMove(0.5);
    score.addTurn();
    expect(read(score, "total-distance", "current-run-distance")).toEqual(["7", "7"]);
    expect(score.get("current-run-effective-distance")).toBe("6");
    score.finish();
    expect(read(score, "best-run-distance", "best-run-turns", "score")).toEqual(["7", "1", "7.7"]);
  });

  it("keeps the best of several runs, and counts only turns of a run in it", () => {
    const score = new Score();
    score.addTurn();
    for (const cells of [2, 1, 2]) {
      score.begin();
      score.addMove(cells);
      score.finish();
      score.addMove(1);
    }
    expect(read(score, "best-run-distance", "best-run-turns")).toEqual(["1", "0"]);
    expect(read(score, "total-turns", "total-distance", "score")).toEqual(["1", "8", "1.9"]);
  });

  it("adds 15 to the run after a reset, and ends the run before it", () => {
    const score = new Score();
    score.begin();
    score.addMove(1);
    score.penalize();
    score.addMove(1);
    expect(score.get("current-run-distance")).toBe("1");
    score.begin();
    score.addMove(2);
    expect(score.get("current-run-effective-distance")).toBe("17");
    expect(score.get("total-effective-distance")).toBe("19");
    expect(score.get("total-distance")).toBe("4");
  });
});
