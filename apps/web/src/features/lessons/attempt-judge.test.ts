import type { ChallengeDocument } from "@corridor/challenge";
import type { Snapshot } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { AttemptJudge } from "./attempt-judge.ts";
import { challengeOf } from "./missions/mission.ts";
import { missions } from "./missions/missions.ts";

function challengeOfMission(id: string): ChallengeDocument {
  const mission = missions.find((each) => each.id === id);
  if (mission === undefined) throw new Error(`no mission ${id}`);
  return challengeOf(mission, id, { task: "", short: "", hints: [] });
}

function snapshot(changes: Partial<Snapshot>): Snapshot {
  return {
    seq: 0,
    tick: 0,
    state: "running",
    driver: "me",
    sensors: { front: 650, right: 50, back: 50, left: 50 },
    pose: { x: 150, y: 150, heading: 90 },
    motion: "forward",
    bumps: 0,
    bumping: false,
    goalReached: false,
    line: null,
    command: null,
    ...changes,
  };
}

const at = (x: number) => ({ x, y: 150, heading: 90 });
const start = snapshot({});

describe("the judge of an attempt", () => {
  it("takes a stop only when the robot stays where the sensor says", () => {
    const judge = new AttemptJudge(challengeOfMission("how-far"), 0);
    const there = {
      tick: 300,
      pose: at(650),
      sensors: { front: 150, right: 50, back: 550, left: 50 },
    };
    judge.see(start);
    expect(judge.see(snapshot(there)).kind).toBe("open");
    expect(judge.see(snapshot({ ...there, motion: "stop", state: "paused" }))).toEqual({
      kind: "met",
      driver: "me",
      tick: 300,
      bumps: 0,
    });
    // What comes after takes nothing back; a new start does.
    expect(judge.see(snapshot({ tick: 310, pose: at(660), bumps: 3 })).kind).toBe("met");
    expect(judge.see(start).kind).toBe("open");
  });

  it("fails at the first bump too many and stays so until the robot starts again", () => {
    const judge = new AttemptJudge(challengeOfMission("no-room"), 0);
    judge.see(snapshot({ driver: "program" }));
    const bump = snapshot({ tick: 255, driver: "program", pose: at(575), bumps: 1 });
    expect(judge.see(bump)).toEqual({ kind: "failed", code: "bump", tick: 255 });
    const goal = snapshot({ tick: 300, driver: "program", bumps: 1, goalReached: true });
    expect(judge.see(goal).kind).toBe("failed");
    expect(judge.see(start).kind).toBe("open");
  });

  it("does not count a goal that somebody else drove to", () => {
    const judge = new AttemptJudge(challengeOfMission("one-line"), 0);
    judge.see(start);
    judge.see(snapshot({ tick: 60, pose: at(250) }));
    const goal = snapshot({ tick: 100, driver: "program", pose: at(280), goalReached: true });
    expect(judge.see(goal)).toEqual({ kind: "failed", code: "driver", tick: 100 });
  });

  it("says when the time is over", () => {
    const judge = new AttemptJudge(challengeOfMission("one-line"), 0);
    judge.see(snapshot({ driver: "program" }));
    expect(judge.see(snapshot({ tick: 1200, driver: "program" })).kind).toBe("open");
    expect(judge.see(snapshot({ tick: 1201, driver: "program" }))).toEqual({
      kind: "failed",
      code: "late",
      tick: 1201,
    });
  });
});
