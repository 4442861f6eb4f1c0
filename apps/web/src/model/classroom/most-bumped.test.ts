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
    { ...place, maze: "u7", count: 2 },
    { ...place, maze: "u31", count: 3 },
  ];
  const counts = { most: 4, given: 3, unseen: 5 };
  expect(mostBumped(1, all)).toEqual({ maze: "g2", cells: [two, { ...two, row: 4 }], counts });
  const none = { most: 0, given: 0, unseen: 0 };
  expect(mostBumped(3, all)).toEqual({ maze: "g1", cells: [], counts: none });
});

it("an unseen maze with most bumps is not among the other ones", () => {
  const unseen = { ...place, maze: "u7", count: 2 };
  const all = [{ ...place, maze: "g1", count: 1 }, unseen, { ...unseen, maze: "u8", count: 1 }];
  const counts = { most: 2, given: 1, unseen: 1 };
  expect(mostBumped(1, all)).toEqual({ maze: "u7", cells: [unseen], counts });
});
