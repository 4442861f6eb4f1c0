import type { Snapshot } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { pitchOf, SoundPlan, tickGap } from "./sound-plan.ts";

/** A plan that records its sounds, with a clock that the test controls. */
function bench() {
  const played: string[] = [];
  let time = 0;
  const plan = new SoundPlan(
    {
      tick: () => void played.push("tick"),
      note: (hertz) => void played.push(`note ${Math.round(hertz)}`),
      bump: () => void played.push("bump"),
      goal: () => void played.push("goal"),
    },
    () => time,
  );
  let tick = 0;
  let last = snapshotOf({ tick, state: "running", line: "default", motion: "forward" });
  plan.show(last, "now");
  return {
    plan,
    played,
    /** advances the clock in steps of 10 ms */
    pass: (milliseconds: number) => {
      for (const end = time + milliseconds; time < end;) {
        time += 10;
        plan.advance();
      }
    },
    frame: (changes: Partial<Snapshot>, view: "now" | "past" | "playing" = "now") => {
      last = { ...last, tick: ++tick, ...changes };
      plan.show(last, view);
    },
  };
}
const front = (cm: number) => ({ front: cm, right: 50, back: 50, left: 50 });

describe("the sounds of a run", () => {
  it("tick faster as the chosen beam gets shorter", () => {
    const count = (cm: number) => {
      const { plan, played, frame, pass } = bench();
      plan.beam = "front";
      frame({ sensors: front(cm) });
      pass(3000);
      return played.filter((each) => each === "tick").length;
    };
    const counts = [400, 200, 100, 50, 25].map(count);
    expect(counts).toEqual(counts.toSorted((a, b) => a - b));
    expect(counts[0]).toBe(4);
    expect(counts[4]).toBeGreaterThan(30);
    expect(tickGap(10_000)).toBe(tickGap(1000));
    expect(tickGap(0)).toBe(80);
  });

  it("tick only while a beam is chosen and the robot moves in the displayed moment", () => {
    const { plan, played, frame, pass } = bench();
    pass(2000);
    expect(played).toEqual([]);
    plan.beam = "left";
    frame({ state: "paused" });
    pass(2000);
    frame({ state: "running" }, "past");
    pass(2000);
    expect(played).toEqual([]);
    frame({ state: "running" }, "playing");
    pass(200);
    expect(played).toContain("tick");
  });

  it("have a note for each decision, higher for later lines", () => {
    const { played, frame, pass } = bench();
    frame({ line: 0 });
    pass(200);
    frame({ line: 0 });
    pass(200);
    frame({ line: 1 });
    pass(200);
    frame({ line: "default" });
    expect(played).toEqual(
      [pitchOf(0), pitchOf(1), pitchOf("default")].map((each) => `note ${Math.round(each)}`),
    );
    const pitches = Array.from({ length: 11 }, (_, line) => pitchOf(line));
    expect(pitches).toEqual(pitches.toSorted((a, b) => a - b));
    expect(pitchOf("default")).toBeLessThan(pitchOf(0));
    expect(pitchOf(199)).toBe(pitchOf(10));
  });

  it("are limited if the line changes with every frame", () => {
    const { played, frame, pass } = bench();
    for (let at = 0; at < 200; at++) {
      frame({ line: at % 2, bumps: at });
      pass(10);
    }
    expect(played.length).toBeLessThan(2000 / 60);
    expect(played.filter((each) => each === "bump").length).toBeLessThanOrEqual(7);
  });

  it("have a bump and a goal, once each, and none for what is looked at again", () => {
    const { played, frame, pass } = bench();
    frame({ bumps: 1 });
    frame({ bumps: 1 });
    pass(500);
    frame({ goalReached: true, state: "paused" });
    frame({ goalReached: true, state: "paused" });
    expect(played).toEqual(["bump", "goal"]);
    frame({ tick: 0, bumps: 0, goalReached: false }, "past");
    frame({ bumps: 1, goalReached: true }, "past");
    // Reset restarts in silence.
    frame({ tick: 0, bumps: 0, goalReached: false });
    expect(played).toEqual(["bump", "goal"]);
  });
});
