import { expect, it } from "vitest";
import { blendHeading } from "./blend-heading.ts";

it.each([
  { from: 0, to: 90, share: 0.5, heading: 45 },
  { from: 350, to: 10, share: 0.5, heading: 0 },
  { from: 10, to: 350, share: 0.25, heading: 5 },
  { from: 270, to: 180, share: 1, heading: 180 },
  { from: 123, to: 200, share: 0, heading: 123 },
])("a turn from $from to $to is at $heading after $share of it", ({ from, to, share, heading }) => {
  expect(blendHeading(from, to, share)).toBe(heading);
});
