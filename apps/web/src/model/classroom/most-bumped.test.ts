import { expect, it } from "vitest";
import { mostBumped } from "./most-bumped.ts";

const place = { task: 1, column: 1, row: 1 };

it("the bumps of a task are those of the maze with most of them", () => {
  const two = { ...place, maze: "g2", count: 2 };
  const all = [
    { ...place, maze: "g1", count: 3 },
    { ...place, task: 2, maze: "g1", count: 9 },
    two,
    { ...two, row: 4 },
  ];
  expect(mostBumped(1, all)).toEqual({ maze: "g2", cells: [two, { ...two, row: 4 }] });
  expect(mostBumped(3, all)).toEqual({ maze: "g1", cells: [] });
});
