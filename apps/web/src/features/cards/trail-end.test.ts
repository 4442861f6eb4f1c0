import { describe, expect, it } from "vitest";
import { trailEnd, trailSide } from "./trail-end.ts";

describe("the end of the trail", () => {
  it.each([
    { heading: 0, touched: { x: 300, y: 275 }, box: { x: 290, y: 290, width: 20, height: 120 } },
    { heading: 90, touched: { x: 325, y: 300 }, box: { x: 190, y: 290, width: 120, height: 20 } },
    { heading: 90, touched: { x: 275, y: 300 }, box: { x: 290, y: 290, width: 120, height: 20 } },
    { heading: 180, touched: { x: 310, y: 320 }, box: { x: 290, y: 190, width: 20, height: 120 } },
  ])(
    "is on the side away from the contact of a robot that faces $heading",
    ({ heading, touched, box }) => {
      const pose = { x: 300, y: 300, heading };
      const end = trailEnd(pose, trailSide(pose, touched));
      for (const side of ["x", "y", "width", "height"] as const) {
        expect(end[side]).toBeCloseTo(box[side], 6);
      }
    },
  );
});
