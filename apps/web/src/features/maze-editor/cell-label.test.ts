import type { MazeDocument } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { cellLabel } from "./cell-label.ts";
import { cellOf, facingOf } from "../../stage/page/robot-place.ts";

const { t } = createI18n(en);
const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["...", ".#."],
  start: { column: 0, row: 0, heading: "west" },
  goals: [{ column: 2, row: 0 }],
};

describe("a square", () => {
  it.each([
    { column: 1, row: 1, robot: null, label: "row 2, column 2, block" },
    { column: 0, row: 1, robot: null, label: "row 2, column 1, open" },
    { column: 0, row: 0, robot: null, label: "row 1, column 1, open, start, facing left" },
    {
      column: 2,
      row: 0,
      robot: "up",
      label: "row 1, column 3, open, goal, robot here, facing up",
    },
  ] as const)("is read as: $label", ({ column, row, robot, label }) => {
    expect(cellLabel(t, maze, { column, row }, robot)).toBe(label);
  });
});

describe("the robot's place", () => {
  it.each([
    { heading: 0, facing: "up" },
    { heading: 22, facing: "up" },
    { heading: 45, facing: "upRight" },
    { heading: 90, facing: "right" },
    { heading: 180, facing: "down" },
    { heading: 270, facing: "left" },
    { heading: 359.9, facing: "up" },
  ])("at $heading degrees it faces $facing", ({ heading, facing }) => {
    expect(facingOf(heading)).toBe(facing);
  });

  it("is the square under its centre", () => {
    expect(cellOf({ x: 650, y: 282, heading: 0 })).toEqual({ column: 6, row: 2 });
  });
});
