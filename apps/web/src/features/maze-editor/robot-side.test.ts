import { expect, it } from "vitest";
import { robotSide } from "./robot-side.ts";

const area = { width: 900, height: 600 };

it.each([
  { name: "in the middle", x: 450, y: 300, side: null },
  { name: "at the upper edge", x: 450, y: 60, side: "upper" },
  { name: "at the lower edge", x: 450, y: 560, side: "lower" },
  { name: "just above a message", x: 450, y: 460, side: null },
  { name: "beside a message, low", x: 60, y: 560, side: null },
  { name: "half beside a message, low", x: 120, y: 560, side: "lower" },
])("a robot $name is at the side: $side", ({ x, y, side }) => {
  expect(robotSide({ x, y, half: 20 }, area)).toBe(side);
});
