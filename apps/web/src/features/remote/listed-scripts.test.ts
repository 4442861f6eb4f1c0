import { describe, expect, it } from "vitest";
import type { ListedScript } from "../../simulator/protocol/worker-messages.ts";
import { quietSeconds, shownScripts } from "./listed-scripts.ts";

const NOW = 1_000_000;

function script(change: Partial<ListedScript>): ListedScript {
  const base = { id: "AAAAAAAA", driver: "Zx81qP", name: null, client: "Python" };
  return {
    ...base,
    connections: 0,
    seenAt: NOW,
    last: null,
    lastProblem: null,
    isBlocked: false,
    ...change,
  };
}

describe("the scripts in the panel", () => {
  it("retain their places, whichever was active last", () => {
    const anna = script({ id: "1", name: "Anna", seenAt: NOW });
    const ben = script({ id: "2", name: "Ben", seenAt: NOW - 9_000 });
    const names = (list: ListedScript[]) => shownScripts(list, NOW).map(({ name }) => name);
    expect(names([ben, anna])).toEqual(["Anna", "Ben"]);
    expect(names([anna, { ...ben, seenAt: NOW + 1 }])).toEqual(["Anna", "Ben"]);
  });

  it("disappear after two minutes without a request, unless they are connected or blocked", () => {
    const long = { seenAt: NOW - 130_000 };
    const list = [
      script({ id: "1", ...long }),
      script({ id: "2", ...long, connections: 1 }),
      script({ id: "3", seenAt: null, isBlocked: true }),
    ];
    expect(shownScripts(list, NOW).map(({ id }) => id)).toEqual(["2", "3"]);
  });

  it("are quiet after five seconds without a request", () => {
    expect(quietSeconds(script({ seenAt: NOW - 4_900 }), NOW)).toBe(0);
    expect(quietSeconds(script({ seenAt: NOW - 12_300 }), NOW)).toBe(12);
    expect(quietSeconds(script({ seenAt: NOW - 12_300, connections: 1 }), NOW)).toBe(0);
    expect(quietSeconds(script({ seenAt: null, isBlocked: true }), NOW)).toBe(0);
  });
});
