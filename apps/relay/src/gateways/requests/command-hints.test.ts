import { orderSchema, readValue } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { withCommandHint } from "./command-hints.ts";

function expectedFor(body: unknown): string | undefined {
  const read = readValue(orderSchema, body);
  if (read.ok) throw new Error("the command is valid");
  return withCommandHint(body, read.problems)[0]?.expected;
}

describe("an invalid command names what was probably meant", () => {
  it.each([
    [{ action: "left 90", degrees: 45 }, "the action turn with the field degrees: -45"],
    [{ action: "right 90", degrees: 45 }, "the action turn with the field degrees: 45"],
    [{ action: "turn 180", degrees: 90 }, "the action turn with the field degrees: 90"],
    [{ action: "left 45" }, "the action turn with the field degrees: -45"],
    [{ action: "turn 45" }, "the action turn with the field degrees: 45"],
    [{ action: "turn -45" }, "the action turn with the field degrees: -45"],
    [{ action: "left" }, "'left 90'"],
    [{ action: "Right" }, "'right 90'"],
    [{ action: "left", degrees: 45 }, "the action turn with the field degrees: -45"],
    [{ action: "forward", distance: 100 }, "the action move with the field distance: 100"],
    [{ action: "reverse", distance: 50 }, "the action move with the field distance: -50"],
    [{ action: "backward", distance: 50 }, "the action move with the field distance: -50"],
    [{ action: "forward 100" }, "the action move with the field distance: 100"],
    [{ action: "FORWARD" }, "forward, or another of reverse"],
    [{ action: "forwards" }, "forward, or another of reverse"],
    [{ action: "left90" }, "left 90, or another of forward"],
    [{ action: "stops" }, "stop, or another of forward"],
  ])("%j", (body, expected) => {
    expect(expectedFor(body)).toContain(expected);
  });

  it.each([
    [{ action: "fly" }, "one of forward, reverse"],
    [{ action: "turn", degrees: "far" }, "an angle in degrees from -3600 to 3600"],
    [{ action: "move", distance: "far" }, "a distance in cm"],
    [{ action: "stop", now: true }, "no field of this name"],
    [{ action: "stop", until: [{ goal: true }] }, "until only with forward, reverse, or drive"],
    [{ action: "forward", until: [] }, "a list of 1 to 200 conditions"],
    [{}, "one of forward, reverse"],
  ])("%j is explained by its field", (body, expected) => {
    expect(expectedFor(body)).toContain(expected);
  });
});
