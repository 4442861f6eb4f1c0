import type { Tile } from "@corridor/protocol";
import { expect, it } from "vitest";
import { noLiveBumps, withoutRecorded, withTileBumps, type LiveBumps } from "./live-bumps.ts";
import { record } from "./testing/class-of.ts";

const tile: Tile = {
  seq: 1,
  task: 1,
  maze: "g1",
  state: "driving",
  pose: [150, 250, 90],
  path: "",
  line: 0,
  tick: 60,
  bumps: 0,
  passes: null,
};

/** The bumps after these tiles and records (numbers of bumps), in order. */
function bumpsAfter(...events: (Partial<Tile> | number)[]): LiveBumps {
  let [live, before] = [noLiveBumps, tile];
  for (const event of events) {
    if (typeof event === "number") {
      const run = { kind: "run", task: 1, changed: true, mistakes: 0, failure: null } as const;
      live = withoutRecorded(live, record(1, 1, { ...run, bumps: event }));
      continue;
    }
    const next = { ...before, ...event };
    live = withTileBumps(live, before, next, "0123456ab");
    before = next;
  }
  return live;
}

const bump: Partial<Tile> = { bumps: 1, tick: 90 };
const reset: Partial<Tile> = { bumps: 0, tick: 0 };

it.each<{ what: string; events: (Partial<Tile> | number)[]; count: number }>([
  { what: "without a bump", events: [{ tick: 90 }], count: 0 },
  { what: "with a bump", events: [bump], count: 1 },
  { what: "with three bumps between two tiles", events: [{ bumps: 3, tick: 90 }], count: 3 },
  { what: "in the next run", events: [bump, 1, reset, bump], count: 1 },
  { what: "whose record has arrived", events: [bump, 1], count: 0 },
  { what: "whose record arrived before its tile", events: [1, bump], count: 0 },
  {
    what: "whose record arrives after the next run bumped",
    events: [bump, reset, bump, 1],
    count: 1,
  },
  {
    what: "after a reset whose tile was missed",
    events: [bump, 1, { bumps: 2, tick: 5 }],
    count: 2,
  },
  {
    what: "in another maze, about which nothing is known",
    events: [{ ...bump, maze: "g2" }],
    count: 0,
  },
  { what: "on something else than the lesson", events: [{ ...bump, maze: null }], count: 0 },
])("a run $what has $count bumps that no record has", ({ events, count }) => {
  const { places } = bumpsAfter(...events);
  expect(places.reduce((sum, each) => sum + each.count, 0)).toBe(count);
});

it("a bump is in the cell of the robot", () => {
  expect(bumpsAfter(bump).places).toEqual([
    { lesson: "0123456ab", task: 1, maze: "g1", column: 1, row: 2, count: 1 },
  ]);
});
