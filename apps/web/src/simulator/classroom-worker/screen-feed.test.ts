import { screenContentSchema, type ScreenContent, type Tile } from "@corridor/protocol";
import { expect, it } from "vitest";
import { ScreenFeed } from "./screen-feed.ts";

const numbers = {
  task: 1,
  solved: 2,
  all: 3,
  medianMs: 61_000,
  lines: { value: 2, count: 1, all: 2 },
  maze: "g1",
  bumps: [{ column: 1, row: 1, count: 4 }],
  bumpCounts: { most: 4, given: 0, unseen: 2 },
  racers: [],
  raceMaze: "g1",
  missing: 0,
};

function update(student: number | null, program: string | null, priority = 1) {
  return { numbers, student, program, priority };
}

function newFeed() {
  const sent: ScreenContent[] = [];
  const priorities: number[] = [];
  const timers: (() => void)[] = [];
  let tile: Tile = {
    seq: 1,
    task: 1,
    maze: "g1",
    state: "driving",
    pose: [150, 150, 90],
    path: "e1",
    line: 0,
    tick: 1,
    bumps: 0,
    passes: null,
  };
  const feed = new ScreenFeed({
    tileOf: () => tile,
    isSolved: () => false,
    send: (content, priority) => {
      sent.push(content);
      priorities.push(priority);
    },
    after: (_ms, call) => timers.push(call),
  });
  return {
    feed,
    sent,
    priorities,
    drive: (path: string): void => {
      tile = { ...tile, path };
      feed.changed([7]);
    },
    pass: (): void => {
      for (const call of timers.splice(0)) call();
    },
  };
}

it("big screens receive numbers at once, and the newest run a second later", () => {
  const { feed, sent, drive, pass } = newFeed();
  feed.show(update(null, null));
  feed.show(update(7, "1Qk3"));
  drive("e2");
  drive("e3");
  expect(sent).toEqual([{ ...numbers, run: null }]);
  pass();
  expect(sent[1]?.run).toMatchObject({ path: "e3", isSolved: false, line: 0, program: "1Qk3" });
  pass();
  expect(sent).toHaveLength(2);
});

it("a new connection sends the content again", () => {
  const { feed, sent, pass } = newFeed();
  feed.show(update(7, "1Qk3"));
  pass();
  feed.repeat();
  expect(sent).toHaveLength(2);
});

it("a choice sends the content again, because another device may control the screens", () => {
  const { feed, priorities, pass } = newFeed();
  feed.show(update(7, "1Qk3", 5));
  pass();
  feed.show(update(7, "1Qk3", 8));
  expect(priorities).toEqual([5, 8]);
});

it("the content names no student, and the big screen accepts it", () => {
  const { feed, sent } = newFeed();
  feed.show(update(7, "1Qk3"));
  expect(screenContentSchema.safeParse(sent[0]).success).toBe(true);
  expect(JSON.stringify(sent)).not.toContain("student");
});
