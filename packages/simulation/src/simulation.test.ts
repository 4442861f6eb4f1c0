import type { MazeDocument } from "@corridor/maze";
import type { Command } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { ROBOT_RADIUS } from "./settings.ts";
import { Simulation } from "./simulation.ts";
import { anyCommand, anyMaze, mazeOf, overlap } from "./testing/mazes.ts";

const hall = mazeOf(["#########", "#.......#", "#.......#", "#.......#", "#########"], {
  column: 4,
  row: 2,
});

/** Runs a command to its end or for a number of ticks. Returns the number of ticks. */
function drive(simulation: Simulation, command: Command, ticks = 0): number {
  const from = simulation.tick;
  simulation.apply(command);
  if (ticks > 0) for (let i = 0; i < ticks; i++) simulation.step();
  else while (simulation.isManoeuvring) simulation.step();
  return simulation.tick - from;
}

describe("an action on open floor", () => {
  it.each<{ command: Command; x: number; y: number; heading: number; ticks: number }>([
    { command: { action: "move", distance: 120 }, x: 570, y: 250, heading: 90, ticks: 72 },
    { command: { action: "move", distance: -120 }, x: 330, y: 250, heading: 90, ticks: 72 },
    { command: { action: "move", distance: 0.5 }, x: 450.5, y: 250, heading: 90, ticks: 1 },
    { command: { action: "left 90" }, x: 450, y: 250, heading: 0, ticks: 36 },
    { command: { action: "right 90" }, x: 450, y: 250, heading: 180, ticks: 36 },
    { command: { action: "turn 180" }, x: 450, y: 250, heading: 270, ticks: 72 },
    { command: { action: "turn", degrees: 37 }, x: 450, y: 250, heading: 127, ticks: 15 },
    { command: { action: "turn", degrees: -400 }, x: 450, y: 250, heading: 50, ticks: 160 },
    { command: { action: "delayed right 90" }, x: 500, y: 310, heading: 180, ticks: 102 },
    { command: { action: "delayed left 90" }, x: 500, y: 190, heading: 0, ticks: 102 },
  ])("$command.action ends at ($x, $y) facing $heading", ({ command, x, y, heading, ticks }) => {
    const simulation = new Simulation(hall);
    expect(drive(simulation, command)).toBe(ticks);
    const { pose, motion, bumps } = simulation.report();
    expect(pose.x).toBeCloseTo(x, 9);
    expect(pose.y).toBeCloseTo(y, 9);
    expect(pose.heading).toBe(heading);
    expect({ motion, bumps, ending: simulation.ending }).toEqual({
      motion: "stop",
      bumps: 0,
      ending: "completed",
    });
  });

  it("forward and reverse drive 100 cm per second until the next command", () => {
    const simulation = new Simulation(hall);
    drive(simulation, { action: "forward" }, 60);
    expect(simulation.pose.x).toBeCloseTo(550, 9);
    expect(simulation.report().motion).toBe("forward");
    drive(simulation, { action: "reverse" }, 120);
    expect(simulation.pose.x).toBeCloseTo(350, 9);
    drive(simulation, { action: "stop" }, 60);
    expect(simulation.pose.x).toBeCloseTo(350, 9);
    expect(simulation.distance).toBeCloseTo(300, 9);
  });

  it("drive(0.2, -0.2) for 602 ms turns right by 90 degrees within 1, on the spot", () => {
    const simulation = new Simulation(hall);
    drive(simulation, { action: "drive", left: 0.2, right: -0.2, milliseconds: 602 });
    expect(Math.abs(simulation.pose.heading - 180)).toBeLessThanOrEqual(1);
    expect(simulation.pose).toMatchObject({ x: 450, y: 250 });
  });

  it("drive with unequal powers drives an arc with the radius of a differential drive", () => {
    const simulation = new Simulation(hall);
    // Radius = track / 2 * (left + right) / (left - right) = 20 * 0.6 / 0.2 = 60, clockwise.
    simulation.apply({ action: "drive", left: 0.4, right: 0.2 });
    for (let tick = 0; tick < 300; tick++) {
      simulation.step();
      const { x, y } = simulation.pose;
      expect(Math.hypot(x - 450, y - 310)).toBeCloseTo(60, 1);
    }
  });
});

describe("contact", () => {
  it("stops the robot at the wall without turning or sliding, and counts one bump", () => {
    const simulation = new Simulation(hall);
    drive(simulation, { action: "turn", degrees: 20 });
    drive(simulation, { action: "forward" }, 600);
    const touched = simulation.report();
    expect(touched).toMatchObject({ bumps: 1, bumping: true, motion: "forward" });
    expect(touched.pose.heading).toBe(110);
    expect(overlap(hall, touched.pose.x, touched.pose.y)).toBeCloseTo(0, 6);
    // On the straight line from the centre, 20 degrees south of east.
    const slope = (touched.pose.y - 250) / (touched.pose.x - 450);
    expect(slope).toBeCloseTo(Math.tan((20 * Math.PI) / 180), 6);
    const before = simulation.pose;
    drive(simulation, { action: "forward" }, 600);
    expect(simulation.bumps).toBe(1);
    expect(simulation.pose.x).toBeCloseTo(before.x, 9);
    expect(simulation.pose.y).toBeCloseTo(before.y, 9);
  });

  it.each([5e-324, 1e-200, 1e-163, -1e-170])(
    "keeps the robot's position at a power of %d",
    (power) => {
      for (let degrees = 0; degrees < 360; degrees += 7) {
        const simulation = new Simulation(hall);
        drive(simulation, { action: "turn", degrees });
        drive(simulation, { action: "forward" }, 600);
        const touched = simulation.report();
        drive(simulation, { action: "drive", left: power, right: power }, 5);
        const { tick, motion } = simulation.report();
        expect(simulation.report()).toEqual({ ...touched, tick, motion });
      }
    },
  );

  it("counts a new bump after the robot left the wall, and for the other wall of a corner", () => {
    const corner = mazeOf(["###", "#.#", "###"]);
    const simulation = new Simulation(corner);
    drive(simulation, { action: "forward" }, 60);
    expect(simulation.bumps).toBe(1);
    drive(simulation, { action: "stop" }, 10);
    drive(simulation, { action: "forward" }, 10);
    expect(simulation.bumps).toBe(1);
    drive(simulation, { action: "right 90" });
    expect(simulation.report().bumping).toBe(true);
    drive(simulation, { action: "forward" }, 60);
    expect(simulation.bumps).toBe(2);
    drive(simulation, { action: "reverse" }, 5);
    expect(simulation.report().bumping).toBe(false);
    drive(simulation, { action: "forward" }, 60);
    expect(simulation.bumps).toBe(3);
  });

  it("ends the current part of a delayed turn and starts the next part", () => {
    const simulation = new Simulation(mazeOf(["###", "#.#", "#.#", "###"]));
    // 25 cm to the wall instead of 50, then the turn, then 60 cm down the side corridor.
    expect(drive(simulation, { action: "delayed right 90" })).toBe(16 + 36 + 36);
    const { pose, bumps } = simulation.report();
    expect(pose).toEqual({ x: expect.closeTo(175, 6), y: expect.closeTo(210, 6), heading: 180 });
    expect({ bumps, ending: simulation.ending }).toEqual({ bumps: 1, ending: "collided" });
  });

  it("ends a measured move as collided", () => {
    const simulation = new Simulation(mazeOf(["###", "#.#", "###"]));
    drive(simulation, { action: "move", distance: 300 });
    expect(simulation.ending).toBe("collided");
    expect(simulation.distance).toBeCloseTo(25, 6);
  });

  it("with a block's corner stops the robot at most 0.05 cm early", () => {
    const simulation = new Simulation(mazeOf(["....", "..#.", "...."], { column: 0, row: 0 }));
    drive(simulation, { action: "turn", degrees: 43 });
    drive(simulation, { action: "forward" }, 300);
    const { pose, bumping } = simulation.report();
    expect(bumping).toBe(true);
    const depth = overlap(simulationMaze(["....", "..#.", "...."]), pose.x, pose.y);
    expect(depth).toBeLessThanOrEqual(0.01);
    expect(depth).toBeGreaterThan(-0.05);
  });
});

function simulationMaze(blocks: string[]): MazeDocument {
  return mazeOf(blocks, { column: 0, row: 0 });
}

describe("a corner of a block", () => {
  it("stops a robot that turns into it on an arc", () => {
    const maze = mazeOf(["..", ".#"], { column: 0, row: 0 });
    const simulation = new Simulation(maze);
    drive(simulation, { action: "forward" }, 14);
    simulation.apply({ action: "drive", left: -0.8531545034252936, right: 0 });
    for (let tick = 0; tick < 46; tick++) {
      simulation.step();
      expect(overlap(maze, simulation.pose.x, simulation.pose.y)).toBeLessThan(0.001);
    }
  });
});

describe("for any commands in any maze", () => {
  it("the robot never overlaps a block by more than 0.01 cm and its readings stay valid", () => {
    fc.assert(
      fc.property(
        anyMaze,
        fc.array(fc.tuple(anyCommand, fc.integer({ min: 1, max: 90 })), { maxLength: 12 }),
        (maze, script) => {
          const simulation = new Simulation(maze);
          for (const [command, ticks] of script) {
            simulation.apply(command);
            for (let i = 0; i < ticks; i++) {
              simulation.step();
              const { pose, sensors } = simulation.report();
              expect(overlap(maze, pose.x, pose.y)).toBeLessThan(0.01);
              expect(pose.heading).toBeGreaterThanOrEqual(0);
              expect(pose.heading).toBeLessThan(360);
              // Readings start at the centre, and walls are never closer than the radius.
              expect(Math.min(...Object.values(sensors))).toBeGreaterThan(ROBOT_RADIUS - 0.01);
            }
          }
        },
      ),
      // fast-check can shrink doubles for hours. The limit reports the failure earlier, less
      // shrunk.
      { numRuns: 200, interruptAfterTimeLimit: 40_000, markInterruptAsFailure: true },
    );
  });

  it("a turn by a multiple of 90 ends on the exact heading", () => {
    fc.assert(
      fc.property(
        fc.array(fc.constantFrom("left 90", "right 90", "turn 180", "delayed left 90"), {
          minLength: 1,
          maxLength: 30,
        }),
        (actions) => {
          const simulation = new Simulation(hall);
          for (const action of actions) drive(simulation, { action });
          expect(simulation.pose.heading % 90).toBe(0);
        },
      ),
      { numRuns: 50 },
    );
  });

  it("the same commands result in the same snapshots, bit for bit", () => {
    fc.assert(
      fc.property(anyMaze, fc.array(anyCommand, { maxLength: 8 }), (maze, commands) => {
        const run = () => {
          const simulation = new Simulation(maze);
          return commands.map((command) => {
            drive(simulation, command, 40);
            return simulation.report();
          });
        };
        expect(run()).toEqual(run());
      }),
      { numRuns: 50 },
    );
  });
});

describe("the goal", () => {
  const maze = mazeOf(["#####", "#...#", "#####"], {}, [{ column: 3, row: 1 }]);

  it("is reached when the whole robot is inside its cell, and stays reached", () => {
    const simulation = new Simulation(maze);
    drive(simulation, { action: "move", distance: 174 });
    expect(simulation.report().goalReached).toBe(false);
    drive(simulation, { action: "move", distance: 2 });
    expect(simulation.report().goalReached).toBe(true);
    const { goalTick } = simulation;
    drive(simulation, { action: "move", distance: -150 });
    expect(simulation.goalTick).toBe(goalTick);
    simulation.reset();
    expect(simulation.report()).toMatchObject({ tick: 0, goalReached: false, bumps: 0 });
  });
});

describe("replacing the maze", () => {
  const open = mazeOf(["....", "....", "...."]);

  it("keeps the robot's position and updates its readings", () => {
    const simulation = new Simulation(open);
    expect(simulation.report().sensors.front).toBe(250);
    expect(simulation.setMaze(mazeOf(["....", "..#.", "...."]))).toBe(true);
    expect(simulation.report().sensors.front).toBe(50);
    drive(simulation, { action: "forward" }, 60);
    expect(simulation.pose.x).toBeCloseTo(175, 6);
  });

  it.each([
    { name: "a block would overlap the robot", blocks: ["....", ".#..", "...."] },
    { name: "the robot would be outside", blocks: ["."] },
  ])("is rejected if $name", ({ blocks }) => {
    const simulation = new Simulation(open);
    expect(simulation.setMaze(mazeOf(blocks, { column: 0, row: 0 }))).toBe(false);
    expect(simulation.report().sensors.front).toBe(250);
  });
});
