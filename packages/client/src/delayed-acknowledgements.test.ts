import { describe, expect, it } from "vitest";
import { DelayedAcknowledgements } from "./delayed-acknowledgements.ts";

/** Which of the snapshots after these gaps are acknowledged: `A`, or `-` if not. */
function acknowledged(gaps: readonly number[]): string {
  const acknowledgements = new DelayedAcknowledgements();
  let now = 0;
  return gaps.map((ms) => (acknowledgements.read((now += ms)) ? "A" : "-")).join("");
}

const times = (count: number, ms: number): number[] => Array.from({ length: count }, () => ms);

describe("a reader acknowledges", () => {
  it.each([
    { name: "the first snapshot of a connection", gaps: [0], expected: "A" },
    { name: "every second one at 20 a second", gaps: times(9, 50), expected: "A-A-A-A-A" },
    { name: "every second one at 15 a second", gaps: times(9, 1000 / 15), expected: "A-A-A-A-A" },
    { name: "every second one of a burst", gaps: times(6, 0), expected: "A-A-A-" },
    { name: "each of a page that reports rarely", gaps: times(6, 250), expected: "AAAAAA" },
    {
      name: "a late one after an unacknowledged one",
      gaps: [0, 50, 500],
      expected: "A-A",
    },
    {
      name: "each after the relay had to wait",
      gaps: [0, 50, 50, 50, 100, 50, 50, 50],
      expected: "A-A-AAAA",
    },
  ])("$name", ({ gaps, expected }) => {
    expect(acknowledged(gaps)).toBe(expected);
  });

  it("every second one again, some seconds after the last late one", () => {
    const result = acknowledged([0, 100, ...times(110, 50)]);
    expect(result.slice(0, 101)).toBe("A".repeat(101));
    expect(result.slice(-8)).toBe("A-A-A-A-");
  });

  it("the first snapshot of each new connection", () => {
    const acknowledgements = new DelayedAcknowledgements();
    acknowledgements.read(0);
    expect(acknowledgements.read(50)).toBe(false);
    acknowledgements.reset();
    expect(acknowledgements.read(10_000)).toBe(true);
    expect(acknowledgements.read(10_050)).toBe(false);
  });

  it("at least one of any two in a row, so that the relay never waits in vain", () => {
    let ms = 7;
    const gaps = Array.from({ length: 2_000 }, () => (ms = (ms * 137 + 11) % 211));
    expect(acknowledged(gaps)).not.toContain("--");
  });
});
