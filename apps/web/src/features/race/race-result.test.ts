import { describe, expect, it } from "vitest";
import type { RaceGhost } from "../../model/run/race-store.ts";
import type { Finish } from "../../simulator/protocol/worker-messages.ts";
import { raceResult } from "./race-result.ts";

const finish = (goalTick: number | null): Finish => ({
  goalTick,
  bumps: 0,
  driver: "program",
  lines: 1,
});
const ghost = (badge: string, goalTick: number | null): RaceGhost => ({
  id: badge.charCodeAt(0),
  badge,
  program: "",
  digest: badge,
  finish: finish(goalTick),
});

describe("the result of a race", () => {
  it("waits until the robot is at the goal", () => {
    expect(raceResult({ ghosts: [ghost("A", 100)], you: null })).toEqual({ kind: "waiting" });
    const ended = { ghosts: [ghost("A", 100)], you: finish(null) };
    expect(raceResult(ended)).toEqual({ kind: "waiting" });
  });

  it("names the best ghost and the time between", () => {
    const ghosts = [ghost("A", 300), ghost("B", 240), ghost("C", null)];
    const of = (tick: number) => raceResult({ ghosts, you: finish(tick) });
    expect(of(180)).toEqual({ kind: "you", badge: "B", ticks: 60 });
    expect(of(240)).toEqual({ kind: "same", badge: "B", ticks: 0 });
    expect(of(270)).toEqual({ kind: "ghost", badge: "B", ticks: 30 });
  });

  it("reports that no ghost reached the goal, even while one is loading", () => {
    const loading = { ...ghost("B", null), finish: null };
    const race = { ghosts: [ghost("A", null), loading], you: finish(10) };
    expect(raceResult(race)).toEqual({ kind: "alone" });
  });
});
