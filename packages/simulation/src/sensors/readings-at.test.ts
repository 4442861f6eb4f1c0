import { gridOf } from "@corridor/maze";
import fc from "fast-check";
import { expect, it } from "vitest";
import { Simulation } from "../simulation.ts";
import { anyMaze } from "../testing/mazes.ts";
import { readingsAt } from "./readings-at.ts";

it("reads at the robot's pose what the robot's sensors read", () => {
  fc.assert(
    fc.property(anyMaze, fc.integer({ min: -180, max: 180 }), (maze, degrees) => {
      const robot = new Simulation(maze);
      robot.apply({ action: "turn", degrees });
      while (robot.isManoeuvring) robot.step();
      robot.apply({ action: "forward" });
      for (let tick = 0; tick < 30; tick++) robot.step();
      expect(readingsAt(gridOf(maze), robot.pose)).toEqual(robot.report().sensors);
    }),
  );
});
