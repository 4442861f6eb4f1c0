import { expect, it } from "vitest";
import { buttonSide } from "./button-side.ts";

const view = { width: 390, height: 320 };
const square = (x: number, y: number) => ({ x, y, width: 60, height: 60 });

it.each([
  { name: "where it is expected while nothing is below it", kept: [], side: "right" },
  { name: "there beside a goal below it", kept: [square(330, 60)], side: "right" },
  { name: "on the other side of a goal", kept: [square(330, 0)], side: "left" },
  {
    name: "on the other side of a goal that is partly in sight",
    kept: [square(330, -20)],
    side: "left",
  },
  { name: "there above a goal out of sight", kept: [square(330, -60)], side: "right" },
  {
    name: "over the smaller part where both sides cover something",
    kept: [square(330, 0), square(150, 20)],
    side: "left",
  },
])("the button stands $name", ({ kept, side }) => {
  expect(buttonSide(kept, view, "right")).toBe(side);
});

it("the button stands on the left in right-to-left languages, unless a goal is there", () => {
  expect(buttonSide([], view, "left")).toBe("left");
  expect(buttonSide([square(0, 0)], view, "left")).toBe("right");
});
