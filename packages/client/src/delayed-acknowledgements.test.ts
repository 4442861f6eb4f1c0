import { describe, expect, it } from "vitest";
import { SeenPace } from "./delayed-acknowledgements.ts";

/** Which of the snapshots that come after these pauses are said: `S` said, `-` not. */
function said(pauses: readonly number[]): string {
  const pace = new SeenPace();
  let now = 0;
  return pauses.map((ms) => (pace.read((now += ms)) ? "S" : "-")).join("");
}

const times = (count: number, ms: number): number[] => Array.from({ length: count }, () => ms);

describe("a reader says `seen`", () => {
  it.each([
    { name: "at once for the first of a line", pauses: [0], says: "S" },
    { name: "for every second one at 20 a second", pauses: times(9, 50), says: "S-S-S-S-S" },
    { name: "and at 15 a second", pauses: times(9, 1000 / 15), says: "S-S-S-S-S" },
    { name: "for every second of a burst", pauses: times(6, 0), says: "S-S-S-" },
    { name: "for each of a page that reports seldom", pauses: times(6, 250), says: "SSSSSS" },
    {
      name: "where one comes late, and an earlier one is unsaid",
      pauses: [0, 50, 500],
      says: "S-S",
    },
    {
      name: "for each after the relay was held up",
      pauses: [0, 50, 50, 50, 100, 50, 50, 50],
      says: "S-S-SSSS",
    },
  ])("$name", ({ pauses, says }) => {
    expect(said(pauses)).toBe(says);
  });

  it("for every second one again, some seconds after the last that came late", () => {
    const says = said([0, 100, ...times(110, 50)]);
    expect(says.slice(0, 101)).toBe("S".repeat(101));
    expect(says.slice(-8)).toBe("S-S-S-S-");
  });

  it("anew on a new line, where the relay counts from none", () => {
    const pace = new SeenPace();
    pace.read(0);
    expect(pace.read(50)).toBe(false);
    pace.begin();
    expect(pace.read(10_000)).toBe(true);
    expect(pace.read(10_050)).toBe(false);
  });

  it("of any two in a row for one at least, so that the relay never waits for what is not said", () => {
    let ms = 7;
    const pauses = Array.from({ length: 2_000 }, () => (ms = (ms * 137 + 11) % 211));
    expect(said(pauses)).not.toContain("--");
  });
});
