/** How far Step goes, and what the speed means while a user drives. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { beforeEach, describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import { RunLoop } from "./run-loop.ts";

let time = 0;

beforeEach(() => {
  time = 0;
});

function loopOf(maze: MazeDocument = firstMaze, program: ProgramDocument = firstProgram): RunLoop {
  return new RunLoop(maze, program, () => time);
}

/** Lets real time pass in timer intervals. */
function pass(loop: RunLoop, milliseconds: number): void {
  for (const end = time + milliseconds; time < end;) {
    time += 8;
    loop.advance();
  }
}

describe("Step", () => {
  it("continues to the next change of decision and pauses", () => {
    const loop = loopOf();
    const stops: unknown[] = [];
    for (let step = 0; step < 8; step++) {
      loop.step();
      pass(loop, 20_000);
      const { state, line, tick } = loop.snapshot();
      expect(state).toBe("paused");
      stops.push({ line, tick });
    }
    // Without Step, the same changes occur one after the other.
    const free = loopOf();
    free.run();
    const changes: unknown[] = [];
    let decided = free.snapshot().line;
    while (changes.length < 8) {
      time += 1000 / 60;
      free.advance();
      const { line, tick } = free.snapshot();
      if (line === decided) continue;
      decided = line;
      changes.push({ line, tick });
    }
    expect(stops).toEqual(changes);
  });

  it("is reverted exactly by one decision back, and continues to the same ticks again", () => {
    const loop = loopOf();
    const stops = [loop.snapshot().tick];
    for (let step = 0; step < 8; step++) {
      loop.step();
      pass(loop, 20_000);
      stops.push(loop.snapshot().tick);
    }
    const shown = () => loop.updates.take()?.frame.snapshot.tick;
    const back = stops.slice(0, -1).map(() => {
      loop.seekStep(-1);
      return shown();
    });
    expect(back).toEqual(stops.slice(0, -1).toReversed());
    const forward = stops.slice(1).map(() => {
      loop.step();
      return shown();
    });
    expect(forward).toEqual(stops.slice(1));
  });

  it("goes by one tick on request", () => {
    const loop = loopOf();
    loop.step("tick");
    pass(loop, 500);
    expect(loop.snapshot()).toMatchObject({ tick: 1, state: "paused" });
    loop.seek(0);
    loop.step("tick");
    expect(loop.updates.take()?.frame).toMatchObject({ view: "now", snapshot: { tick: 1 } });
  });

  it("ends where the robot stands or bumps, because nothing is decided there any more", () => {
    const still = loopOf(firstMaze, { ...firstProgram, rules: [], default: "stop" });
    still.step();
    pass(still, 500);
    expect(still.snapshot()).toMatchObject({ tick: 1, state: "paused" });
    const straight = loopOf(firstMaze, { ...firstProgram, rules: [] });
    for (let step = 0; step < 3; step++) {
      straight.step();
      pass(straight, 20_000);
      expect(straight.snapshot()).toMatchObject({ state: "paused", bumps: 1 });
    }
  });

  it("takes a whole manoeuvre where the decision is one", () => {
    const loop = loopOf(firstMaze, { ...firstProgram, rules: [], default: "turn 180" });
    loop.step();
    pass(loop, 3000);
    expect(loop.snapshot()).toMatchObject({ tick: 72, state: "paused" });
    expect(loop.snapshot().pose.heading).toBe(270);
  });
});

describe("the speed", () => {
  it.each([0.25, 0.5, 1, 2, 4, 8, 16, "max"] as const)(
    "does not depend on the speed %s under a hand: a key held for 120 ms drives 12 cm",
    (speed) => {
      const loop = loopOf();
      const before = loop.snapshot().pose.x;
      loop.setSpeed(speed);
      loop.hold("forward");
      pass(loop, 120);
      loop.hold("stop");
      pass(loop, 500);
      // Within a tick, in which the robot drives 5/3 cm.
      expect(Math.abs(loop.snapshot().pose.x - before - 12)).toBeLessThanOrEqual(5 / 3);
      // The speed is that of the replay all the same.
      loop.seek(0);
      loop.play();
      pass(loop, 200);
      expect(loop.isRunning).toBe(speed !== "max" && speed < 0.6);
    },
  );

  it("counts a key that is released between two intervals up to that moment", () => {
    const loop = loopOf();
    const before = loop.snapshot().pose.x;
    loop.hold("forward");
    // The timer of a busy machine comes late.
    time += 120;
    loop.hold("stop");
    expect(Math.abs(loop.snapshot().pose.x - before - 12)).toBeLessThanOrEqual(5 / 3);
  });
});
