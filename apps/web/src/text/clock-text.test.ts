import { expect, it } from "vitest";
import { clockText } from "./clock-text.ts";

it.each([
  [0, "0:00"],
  [57, "0:57"],
  [842, "14:02"],
  [3_842, "1:04:02"],
])("%d seconds read as a clock: %s", (seconds, text) => {
  expect(clockText(seconds)).toBe(text);
});
