import { normaliseHeading } from "@corridor/geometry";
import type { Command } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { DRIVE_STEP, TURN_STEP } from "../settings.ts";
import { anyCommand } from "../testing/mazes.ts";
import { MotionController } from "./motion-controller.ts";

/** More than the longest manoeuvre of these tests takes. */
const MOST_TICKS = 2_000;

interface Tick {
  linear: number;
  angular: number;
  /** at the end of the tick */
  heading: number;
}

/** Executes one tick, as the simulation does. */
function tick(motion: MotionController, heading: number, isStopped = false): Tick {
  motion.plan(heading);
  const { linear, angular, exactHeading } = motion;
  motion.finish(isStopped);
  const turned = Number.isNaN(exactHeading) ? normaliseHeading(heading + angular) : exactHeading;
  return { linear, angular, heading: angular === 0 ? heading : turned };
}

/** Executes ticks until the manoeuvre ends. @param stoppedAt ticks in which a block stops it */
function toEnd(motion: MotionController, heading = 90, stoppedAt: number[] = []) {
  let at: Tick = { linear: 0, angular: 0, heading };
  let distance = 0;
  let degrees = 0;
  let ticks = 0;
  while (motion.isManoeuvring && ticks < MOST_TICKS) {
    at = tick(motion, at.heading, stoppedAt.includes(++ticks));
    distance += at.linear;
    degrees += at.angular;
  }
  return { distance, degrees, ticks, heading: at.heading, ending: motion.ending };
}

/** Executes a number of ticks. */
function forTicks(motion: MotionController, count: number, heading = 90): Tick[] {
  const ticks: Tick[] = [];
  for (let n = 0; n < count; n++) ticks.push(tick(motion, ticks.at(-1)?.heading ?? heading));
  return ticks;
}

function started(command: Command): MotionController {
  const motion = new MotionController();
  motion.start(command);
  return motion;
}

const anyHeading = fc.double({ min: 0, max: 359.999, noNaN: true });
const anyTicks = fc.integer({ min: 0, max: 150 });

describe("a manoeuvre", () => {
  it.each<{ command: Command; distance: number; degrees: number; ticks: number }>([
    { command: { action: "left 90" }, distance: 0, degrees: -90, ticks: 36 },
    { command: { action: "right 90" }, distance: 0, degrees: 90, ticks: 36 },
    { command: { action: "turn 180" }, distance: 0, degrees: 180, ticks: 72 },
    { command: { action: "delayed left 90" }, distance: 110, degrees: -90, ticks: 102 },
    { command: { action: "delayed right 90" }, distance: 110, degrees: 90, ticks: 102 },
    { command: { action: "move", distance: 0 }, distance: 0, degrees: 0, ticks: 0 },
    { command: { action: "turn", degrees: 0 }, distance: 0, degrees: 0, ticks: 0 },
    {
      command: { action: "drive", left: 1, right: 1, milliseconds: 1_000 },
      distance: 261,
      degrees: 0,
      ticks: 60,
    },
    // The shortest time is one tick.
    {
      command: { action: "drive", left: -1, right: -1, milliseconds: 1 },
      distance: -4.35,
      degrees: 0,
      ticks: 1,
    },
  ])("$command.action drives $distance units and turns $degrees degrees", (expected) => {
    const motion = started(expected.command);
    const { distance, degrees, ticks, ending } = toEnd(motion);
    expect({ ticks, ending, action: motion.action }).toEqual({
      ticks: expected.ticks,
      ending: "completed",
      action: "stop",
    });
    expect(distance).toBeCloseTo(expected.distance, 9);
    expect(degrees).toBeCloseTo(expected.degrees, 9);
  });

  it("drives exactly the distance of the command, at most at full speed", () => {
    fc.assert(
      fc.property(fc.double({ min: -2_000, max: 2_000, noNaN: true }), (distance) => {
        const driven = toEnd(started({ action: "move", distance }));
        expect(driven.distance).toBeCloseTo(distance, 8);
        expect(driven.ending).toBe("completed");
        expect(Math.abs(driven.ticks - Math.abs(distance) / DRIVE_STEP)).toBeLessThanOrEqual(1);
      }),
    );
  });

  it("ends a turn at the exact heading, from any heading", () => {
    fc.assert(
      fc.property(anyHeading, fc.integer({ min: -720, max: 720 }), (from, degrees) => {
        const { heading, ticks } = toEnd(started({ action: "turn", degrees }), from);
        expect(heading).toBe(degrees === 0 ? from : normaliseHeading(from + degrees));
        expect(ticks).toBe(Math.ceil(Math.abs(degrees) / TURN_STEP));
      }),
    );
  });

  it("ends all four quarter turns where it started", () => {
    fc.assert(
      fc.property(fc.constantFrom("left 90", "right 90"), fc.nat({ max: 3 }), (action, quarter) => {
        let heading = quarter * 90;
        for (let n = 0; n < 4; n++) ({ heading } = toEnd(started({ action }), heading));
        expect(heading).toBe(quarter * 90);
      }),
    );
  });

  it("reports its progress: what is left shrinks in each tick, to nothing", () => {
    fc.assert(
      fc.property(anyCommand, anyHeading, (command, heading) => {
        const motion = started(command);
        const isEndless = !motion.isManoeuvring;
        expect(motion.progress === null).toBe(isEndless);
        let before = motion.progress;
        for (let n = 0; before !== null && n < MOST_TICKS; n++) {
          tick(motion, heading);
          const now = motion.progress;
          expect(before).toMatchObject({ action: command.action, part: expect.any(Number) });
          expect(before.left).toBeLessThanOrEqual(before.of);
          const isSamePart = now?.part === before.part && now.left < before.left;
          expect(isSamePart || (now?.part ?? before.parts) === before.part + 1).toBe(true);
          before = now;
        }
        expect(before).toBeNull();
      }),
    );
  });
});

describe("wheel powers", () => {
  const power = fc.double({ min: -1, max: 1, noNaN: true });
  const speedsOf = (left: number, right: number) =>
    tick(started({ action: "drive", left, right }), 0);

  it.each([
    { name: "equal powers drive straight on", left: 0.5, right: 0.5, turns: 0, drives: 1 },
    {
      name: "equal negative powers drive straight back",
      left: -1,
      right: -1,
      turns: 0,
      drives: -1,
    },
    { name: "opposite powers turn right on the spot", left: 1, right: -1, turns: 1, drives: 0 },
    { name: "opposite powers turn left on the spot", left: -1, right: 1, turns: -1, drives: 0 },
    { name: "more power on the left curves right", left: 1, right: 0.2, turns: 1, drives: 1 },
    { name: "no power stands still", left: 0, right: 0, turns: 0, drives: 0 },
  ])("$name", ({ left, right, turns, drives }) => {
    const { linear, angular } = speedsOf(left, right);
    expect([Math.sign(angular), Math.sign(linear)]).toEqual([turns, drives]);
  });

  it("are mirrored when they are swapped, and keep their speeds until the next command", () => {
    fc.assert(
      fc.property(power, power, anyTicks, (left, right, count) => {
        const { linear, angular } = speedsOf(left, right);
        const swapped = speedsOf(right, left);
        expect(swapped.linear).toBeCloseTo(linear, 12);
        expect(swapped.angular).toBeCloseTo(-angular, 12);
        const motion = started({ action: "drive", left, right });
        for (const each of forTicks(motion, count)) expect(each).toMatchObject({ linear, angular });
        expect(motion.action).toBe("drive");
      }),
    );
  });
});

describe("a contact", () => {
  it.each<{ command: Command; ticks: number; ending: string }>([
    { command: { action: "move", distance: 100 }, ticks: 10, ending: "collided" },
    { command: { action: "move", distance: -100 }, ticks: 10, ending: "collided" },
    // The part ends, and the turn and the way out follow.
    { command: { action: "delayed left 90" }, ticks: 10 + 36 + 36, ending: "collided" },
    // Wheels push on until their time is over.
    {
      command: { action: "drive", left: 1, right: 1, milliseconds: 500 },
      ticks: 30,
      ending: "collided",
    },
  ])("in tick 10 of $command.action ends it in tick $ticks", ({ command, ticks, ending }) => {
    expect(toEnd(started(command), 90, [10])).toMatchObject({ ticks, ending });
  });

  it.each(["forward", "reverse"] as const)("does not end %s, which pushes on", (action) => {
    const motion = started({ action });
    for (let n = 0; n < 100; n++) {
      expect(Math.abs(tick(motion, 90, true).linear)).toBe(DRIVE_STEP);
    }
    expect(motion.action).toBe(action);
    expect(motion.ending).toBeNull();
  });

  it("of one manoeuvre is not reported by the next", () => {
    const motion = started({ action: "move", distance: 50 });
    expect(toEnd(motion, 90, [1]).ending).toBe("collided");
    motion.start({ action: "move", distance: 50 });
    expect(motion.ending).toBeNull();
    expect(toEnd(motion).ending).toBe("completed");
  });
});

describe("a new command", () => {
  const isSteady = ({ action }: Command) => ["forward", "reverse", "stop"].includes(action);

  it("replaces the running one at once, with nothing of it left", () => {
    fc.assert(
      fc.property(anyCommand, anyTicks, anyCommand, anyHeading, (first, count, next, heading) => {
        const motion = started(first);
        const { heading: from = heading } = forTicks(motion, count, heading).at(-1) ?? {};
        motion.start(next);
        const fresh = started(next);
        expect(forTicks(motion, 150, from)).toEqual(forTicks(fresh, 150, from));
        expect(motion.action).toBe(fresh.action);
      }),
    );
  });

  it("that repeats a motion without an end changes nothing", () => {
    fc.assert(
      fc.property(anyCommand.filter(isSteady), fc.array(anyTicks), (command, repeats) => {
        const motion = started(command);
        const [expected] = forTicks(started(command), 1);
        for (const count of repeats) {
          motion.start(command);
          for (const each of forTicks(motion, count)) expect(each).toEqual(expected);
        }
      }),
    );
  });
});

describe("a saved motion", () => {
  it("continues bit for bit in another controller, and as often as it is restored", () => {
    fc.assert(
      fc.property(anyCommand, anyTicks, anyHeading, (command, count, heading) => {
        const motion = started(command);
        const { heading: from = heading } = forTicks(motion, count, heading).at(-1) ?? {};
        const saved = motion.save();
        const expected = forTicks(motion, 150, from);
        for (let times = 0; times < 2; times++) {
          const restored = new MotionController();
          restored.restore(saved);
          expect(forTicks(restored, 150, from)).toEqual(expected);
          expect(restored.save()).toEqual(motion.save());
        }
      }),
    );
  });
});
