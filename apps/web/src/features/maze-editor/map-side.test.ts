import { expect, it } from "vitest";
import { hasMapRoom, mapSide } from "./map-side.ts";

const view = { width: 390, height: 320 };

it.each([
  { name: "left where the robot is in the middle", x: 195, y: 160, map: 106, side: "left" },
  { name: "left below a robot that is far above it", x: 60, y: 60, map: 106, side: "left" },
  { name: "right of a robot in its corner", x: 60, y: 260, map: 106, side: "right" },
  {
    name: "right where only a reading would stand under it",
    x: 60,
    y: 160,
    map: 106,
    side: "right",
  },
  { name: "left where it is low enough for that reading", x: 60, y: 160, map: 42, side: "left" },
])("the small map stands $name", ({ x, y, map, side }) => {
  expect(mapSide({ x, y }, view, { width: 106, height: map })).toBe(side);
});

it("the small map is left out where it would stand over the tools above the stage", () => {
  const map = { width: 106, height: 106 };
  expect(hasMapRoom({ width: 320, height: 64 }, map)).toBe(false);
  expect(hasMapRoom({ width: 473, height: 182 }, map)).toBe(true);
});
