/** Snapshot of the result of each preset program in each preset maze. */
import { mazePresets } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { expect, it } from "vitest";
import { runProgram } from "./run-result.ts";

it("every preset program has the same result as before in every preset maze", () => {
  const table = mazePresets.flatMap(({ id: maze, maze: document }) =>
    programPresets.map(({ id: program, program: rules }) => {
      const result = runProgram(document, rules, { seconds: 120, until: "time" });
      const { bumps, visitedCells, openCells, goalTick } = result;
      const goal = goalTick === null ? "no goal" : `goal at tick ${goalTick}`;
      return `${maze}, ${program}: ${goal}, ${bumps} bumps, ${visitedCells} of ${openCells} cells`;
    }),
  );
  expect(table).toMatchInlineSnapshot(`
    [
      "first-steps, back-and-forth: no goal, 0 bumps, 4 of 8 cells",
      "first-steps, right-wall: goal at tick 478, 0 bumps, 8 of 8 cells",
      "first-steps, left-wall: goal at tick 478, 0 bumps, 8 of 8 cells",
      "first-steps, farthest-distance: goal at tick 478, 0 bumps, 8 of 8 cells",
      "first-steps, left-at-every-wall: no goal, 0 bumps, 4 of 8 cells",
      "straight-corridor, back-and-forth: goal at tick 465, 0 bumps, 9 of 9 cells",
      "straight-corridor, right-wall: goal at tick 465, 0 bumps, 9 of 9 cells",
      "straight-corridor, left-wall: goal at tick 465, 0 bumps, 9 of 9 cells",
      "straight-corridor, farthest-distance: goal at tick 465, 0 bumps, 9 of 9 cells",
      "straight-corridor, left-at-every-wall: goal at tick 465, 0 bumps, 9 of 9 cells",
      "spiral, back-and-forth: no goal, 0 bumps, 9 of 49 cells",
      "spiral, right-wall: goal at tick 3166, 0 bumps, 49 of 49 cells",
      "spiral, left-wall: goal at tick 3168, 0 bumps, 49 of 49 cells",
      "spiral, farthest-distance: goal at tick 3168, 0 bumps, 49 of 49 cells",
      "spiral, left-at-every-wall: no goal, 0 bumps, 9 of 49 cells",
      "comb, back-and-forth: no goal, 0 bumps, 11 of 29 cells",
      "comb, right-wall: goal at tick 802, 0 bumps, 29 of 29 cells",
      "comb, left-wall: no goal, 44 bumps, 2 of 29 cells",
      "comb, farthest-distance: goal at tick 802, 0 bumps, 17 of 29 cells",
      "comb, left-at-every-wall: goal at tick 802, 0 bumps, 14 of 29 cells",
      "tree, back-and-forth: no goal, 0 bumps, 5 of 97 cells",
      "tree, right-wall: goal at tick 5731, 0 bumps, 77 of 97 cells",
      "tree, left-wall: no goal, 0 bumps, 82 of 97 cells",
      "tree, farthest-distance: goal at tick 5105, 0 bumps, 77 of 97 cells",
      "tree, left-at-every-wall: no goal, 0 bumps, 5 of 97 cells",
      "long-way-round, back-and-forth: no goal, 0 bumps, 3 of 49 cells",
      "long-way-round, right-wall: goal at tick 2380, 0 bumps, 48 of 49 cells",
      "long-way-round, left-wall: goal at tick 2310, 0 bumps, 48 of 49 cells",
      "long-way-round, farthest-distance: goal at tick 2310, 0 bumps, 37 of 49 cells",
      "long-way-round, left-at-every-wall: no goal, 0 bumps, 9 of 49 cells",
      "two-rooms, back-and-forth: no goal, 0 bumps, 5 of 71 cells",
      "two-rooms, right-wall: goal at tick 1211, 0 bumps, 41 of 71 cells",
      "two-rooms, left-wall: no goal, 1 bumps, 4 of 71 cells",
      "two-rooms, farthest-distance: no goal, 0 bumps, 20 of 71 cells",
      "two-rooms, left-at-every-wall: no goal, 0 bumps, 20 of 71 cells",
      "empty, back-and-forth: no goal, 0 bumps, 11 of 77 cells",
      "empty, right-wall: no goal, 0 bumps, 32 of 77 cells",
      "empty, left-wall: no goal, 1 bumps, 4 of 77 cells",
      "empty, farthest-distance: no goal, 0 bumps, 32 of 77 cells",
      "empty, left-at-every-wall: no goal, 0 bumps, 32 of 77 cells",
    ]
  `);
});
