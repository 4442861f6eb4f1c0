import { describe, expect, it } from "vitest";
import { readFrameRequest } from "./frame-messages.ts";

describe("a message to the frame", () => {
  it.each([
    { corridor: 1, type: "open", link: "1abc" },
    { corridor: 1, type: "open", id: "BCDF" },
    { corridor: 1, type: "run" },
    { corridor: 1, type: "stop" },
    { corridor: 1, type: "reset" },
  ])("is a request: %o", (message) => {
    expect(readFrameRequest(message)).toEqual(message);
  });

  it.each([
    null,
    undefined,
    1,
    "run",
    [],
    {},
    { type: "run" },
    { corridor: 2, type: "run" },
    { corridor: "1", type: "run" },
    { corridor: 1 },
    { corridor: 1, type: "drive" },
    { corridor: 1, type: "__proto__" },
    { corridor: 1, type: ["run"] },
    { corridor: 1, type: "open" },
    { corridor: 1, type: "open", link: "" },
    { corridor: 1, type: "open", link: "x".repeat(8_193) },
    { corridor: 1, type: "open", id: "../r/A" },
    { corridor: 1, type: "open", id: {} },
    new Map([["corridor", 1]]),
    new Date(0),
  ])("is ignored otherwise: %o", (message) => {
    expect(readFrameRequest(message)).toBeNull();
  });

  it("ignores 500 random messages", () => {
    let seed = 1;
    const next = (below: number) => {
      seed = (seed * 48_271) % 2_147_483_647;
      return seed % below;
    };
    const value = (depth: number): unknown => {
      const leaves = [1, "open", "corridor", null, undefined, Number.NaN, "run ", true, 1e308];
      if (depth === 0 || next(2) === 0) return leaves[next(leaves.length)];
      if (next(2) === 0) return Array.from({ length: next(4) }, () => value(depth - 1));
      const names = ["corridor", "type", "link", "id", "constructor"];
      return Object.fromEntries(
        names.filter(() => next(2)).map((name) => [name, value(depth - 1)]),
      );
    };
    // None of them has a complete request in it.
    const requests = Array.from({ length: 500 }, () => readFrameRequest(value(3)));
    expect(requests.filter((each) => each !== null && each.type !== "open")).toEqual([]);
  });
});
