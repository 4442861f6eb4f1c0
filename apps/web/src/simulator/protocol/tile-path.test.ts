import { expect, it } from "vitest";
import { pathCells } from "./tile-path.ts";

it("a path leads to the robot, and its oldest part may be missing", () => {
  expect(pathCells({ path: "e4s2", pose: [550, 350, 180] })).toEqual([
    { column: 1, row: 1 },
    { column: 5, row: 1 },
    { column: 5, row: 3 },
  ]);
});

it("a robot that has not moved is its own path", () => {
  expect(pathCells({ path: "", pose: [150, 50, 0] })).toEqual([{ column: 1, row: 0 }]);
});
