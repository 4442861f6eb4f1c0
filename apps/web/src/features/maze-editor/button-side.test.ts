import { expect, it } from "vitest";
import { buttonSide } from "./button-side.ts";

const view = { width: 390, height: 320 };
const square = (x: number, y: number) => ({ x, y, width: 60, height: 60 });

it.each([
  { name: "where it is expected while nothing is below it", avoided: [], side: "right" },
  { name: "there beside a goal below it", avoided: [square(330, 60)], side: "right" },
  { name: "on the other side of a goal", avoided: [square(330, 0)], side: "left" },
  {
    name: "on the other side of a goal that is partly in sight",
    avoided: [square(330, -20)],
    side: "left",
  },
  { name: "there above a goal out of sight", avoided: [square(330, -60)], side: "right" },
  {
    name: "over the smaller part where both sides cover something",
    avoided: [square(330, 0), square(150, 20)],
    side: "left",
  },
])("the button stands $name", ({ avoided, side }) => {
  expect(buttonSide(avoided, view, "right")).toBe(side);
});

it("the button stands on the left in right-to-left languages, unless a goal is there", () => {
  expect(buttonSide([], view, "left")).toBe("left");
  expect(buttonSide([square(0, 0)], view, "left")).toBe("right");
});
