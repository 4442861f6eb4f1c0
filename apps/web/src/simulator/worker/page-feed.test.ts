import { setBlock } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import type { FromWorker } from "../protocol/worker-messages.ts";
import { PageFeed } from "./page-feed.ts";
import { Bench, tenSeconds } from "./testing/bench.ts";

/** Returns the types of the messages to the page for each change of the run, and the messages. */
function feedOf(bench: Bench) {
  const sent: FromWorker[] = [];
  const feed = new PageFeed({
    post: (message) => sent.push(message),
    draw: (frame) => sent.push({ type: "picture", frame }),
    now: () => bench.time,
  });
  const { updates } = bench.loop;
  const after = (act: () => void): string[] => {
    act();
    sent.length = 0;
    bench.time += 1_000;
    feed.send(updates, updates.take());
    return sent.map(({ type }) => type);
  };
  after(() => undefined);
  return { after, sent };
}

describe("messages for the page", () => {
  it("announce that later events were discarded before the frames of the continued run", () => {
    const bench = tenSeconds();
    const { after, sent } = feedOf(bench);
    const continued = after(() => {
      bench.loop.seek(100);
      bench.loop.run();
    });
    expect(continued).toEqual(["truncated", "picture", "frame"]);
    expect(sent[0]).toEqual({ type: "truncated", after: 100 });
  });

  it("contain the maze of an earlier tick before its frame, and again the newest one", () => {
    const bench = tenSeconds();
    const { after, sent } = feedOf(bench);
    const before = bench.loop.maze;
    const edited = setBlock(before, { column: 10, row: 6 }, true);
    if (!edited.ok) throw new Error(edited.code);
    expect(after(() => bench.loop.editMaze(edited.maze))).toEqual(["picture", "frame"]);
    expect(after(() => bench.loop.seek(100))).toEqual(["picture", "past-maze", "frame"]);
    expect(sent[1]).toEqual({ type: "past-maze", maze: before });
    expect(after(() => bench.loop.now())).toEqual(["picture", "past-maze", "frame"]);
    expect(sent[1]).toEqual({ type: "past-maze", maze: null });
  });

  it("are none while nothing changes", () => {
    const { after } = feedOf(new Bench());
    expect(after(() => undefined)).toEqual([]);
  });
});
