import type { Tile } from "@corridor/protocol";
import { expect, it } from "vitest";
import { noLiveBumps, withoutRecorded, withTileBumps, type LiveBumps } from "./live-bumps.ts";
import { emptyTask } from "./student-work.ts";
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

type Event = Partial<Tile> | number;

/** The bumps after these tiles and records (numbers of bumps), in order. */
function bumpsAfter(events: readonly Event[], first: Tile | null = tile, runs = 0): LiveBumps {
  let live = noLiveBumps;
  let before = first;
  for (const event of events) {
    if (typeof event === "number") {
      runs += 1;
      const run = { kind: "run", task: 1, changed: true, mistakes: 0, failure: null } as const;
      live = withoutRecorded(live, record(1, 1, { ...run, bumps: event }));
      continue;
    }
    const next = { ...tile, ...before, ...event };
    const tasks = [1, 2].map((task) => ({ ...emptyTask(task), runs }));
    live = withTileBumps(live, before, next, { lesson: "0123456ab", tasks });
    before = next;
  }
  return live;
}

const bump: Partial<Tile> = { bumps: 1, tick: 90 };
const reset: Partial<Tile> = { bumps: 0, tick: 0 };

it.each<{ what: string; events: Event[]; count: number }>([
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
  { what: "after a reset, if a record was early", events: [1, reset, bump], count: 1 },
  { what: "in another maze", events: [{ ...bump, maze: "g2" }], count: 1 },
  { what: "that was left and is back", events: [bump, { maze: null }, { maze: "g1" }], count: 1 },
  { what: "of another task, that a record may have", events: [1, { bumps: 2, task: 2 }], count: 0 },
  { what: "on something else than the lesson", events: [{ ...bump, maze: null }], count: 0 },
])("a run $what has $count bumps that no record has", ({ events, count }) => {
  const { places } = bumpsAfter(events);
  expect(places.reduce((sum, each) => sum + each.count, 0)).toBe(count);
});

it("a bump is in the cell of the robot", () => {
  expect(bumpsAfter([bump]).places).toEqual([
    { lesson: "0123456ab", task: 1, maze: "g1", column: 1, row: 2, count: 1 },
  ]);
});

it.each([
  { what: "without a record", runs: 0, count: 2 },
  { what: "whose records may have them", runs: 1, count: 0 },
])("the bumps of a run $what are counted when the dashboard opens: $count", ({ runs, count }) => {
  const { places } = bumpsAfter([{ bumps: 2 }], null, runs);
  expect(places.reduce((sum, each) => sum + each.count, 0)).toBe(count);
});
