import { describe, expect, it } from "vitest";
import { documentOf, gridOfDrawing, mouseMazes, turnedClockwise } from "./testing/mouse-mazes.ts";
import { floodFill, followWall } from "./testing/mouse-programs.ts";
import { gridLines, startMouse } from "./testing/mouse-world.ts";

const programs = { "flood fill": floodFill, "a wall follower": followWall };

describe.each(Object.entries(programs))("%s", (_name, program) => {
  it.each(mouseMazes)("has the same transcript in a grid and with a robot: $name", async (maze) => {
    const grid = gridLines(gridOfDrawing(maze.drawing));
    expect(await program(grid.lines)).toBe(true);
    const world = await startMouse(documentOf(maze));
    expect(await program(world.lines)).toBe(true);
    expect(world.transcript).toEqual(grid.transcript);
    expect(world.port.simulation.bumps).toBe(0);
    expect([world.reports, world.ends]).toEqual([[], []]);
  });

  it.each([1, 2, 3])(
    "starts in another corner: the maze turned by %i quarters",
    async (quarters) => {
      const [maze] = mouseMazes;
      if (maze === undefined) throw new Error("no maze");
      const grid = gridLines(gridOfDrawing(maze.drawing));
      await program(grid.lines);
      let document = documentOf(maze);
      for (let quarter = 0; quarter < quarters; quarter += 1) document = turnedClockwise(document);
      const world = await startMouse(document);
      await program(world.lines);
      expect(world.transcript).toEqual(grid.transcript);
    },
  );
});
