import { tileSchema } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { ClassPlace } from "../protocol/class-messages.ts";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import { RunLoop } from "./run-loop.ts";
import { TileFeed } from "./tile-feed.ts";

const place: ClassPlace = { task: 2, maze: "g1", passes: null, isSolved: false, isDriven: false };

/** The tiles of a student at the first project. */
function newFeed() {
  let time = 0;
  const loop = new RunLoop(firstMaze, firstProgram, () => time);
  const feed = new TileFeed({ run: () => loop, now: () => time });
  const wait = (ms: number): void => {
    for (const end = time + ms; time < end; time += 20) loop.advance();
    feed.changed();
  };
  return { loop, feed, wait };
}

describe("the tile of a student", () => {
  it("is not sent before the student opens the lesson", () => {
    const { feed, wait } = newFeed();
    wait(2_000);
    expect(feed.take(false)).toBeNull();
  });

  it("shows the robot at its start, and how it drives", () => {
    const { loop, feed, wait } = newFeed();
    feed.place(place);
    const first = feed.take(false);
    expect(first).toMatchObject({
      seq: 1,
      task: 2,
      maze: "g1",
      state: "writing",
      path: "",
      tick: 0,
    });
    loop.run();
    wait(3_000);
    const second = feed.take(false);
    expect(second).toMatchObject({ seq: 2, state: "driving", line: expect.anything() });
    expect(second?.path).not.toBe("");
    expect(tileSchema.safeParse(second).success).toBe(true);
  });

  it("is sent twice a second, and five times while the teacher watches", () => {
    const { loop, feed, wait } = newFeed();
    feed.place(place);
    loop.run();
    expect(feed.take(false)).not.toBeNull();
    wait(300);
    expect(feed.take(false)).toBeNull();
    expect(feed.take(true)).not.toBeNull();
    wait(500);
    expect(feed.take(false)).not.toBeNull();
  });

  it("is not repeated without a change, except for a new connection", () => {
    const { feed, wait } = newFeed();
    feed.place(place);
    expect(feed.take(false)).not.toBeNull();
    wait(1_000);
    expect(feed.take(false)).toBeNull();
    feed.restart();
    expect(feed.take(false)).not.toBeNull();
  });

  it("shows that the robot bumped, until the robot is reset", () => {
    const { loop, feed, wait } = newFeed();
    feed.place(place);
    loop.hold("forward");
    wait(20_000);
    loop.hold("stop");
    loop.pause();
    feed.changed();
    expect(feed.take(false)).toMatchObject({ state: "bumped", bumps: 1, line: null });
    loop.reset();
    wait(1_000);
    expect(feed.take(false)).toMatchObject({ state: "writing", bumps: 0 });
  });

  it("shows a solved task, also while the robot stands still", () => {
    const { feed } = newFeed();
    feed.place({ ...place, passes: 50, isSolved: true });
    expect(feed.take(false)).toMatchObject({ state: "solved", passes: 50 });
  });

  it("shows that the student drives by hand, also between two keys", () => {
    const { loop, feed, wait } = newFeed();
    feed.place({ ...place, isDriven: true });
    loop.hold("forward");
    wait(500);
    loop.hold("stop");
    wait(500);
    expect(feed.take(false)).toMatchObject({ state: "driving", bumps: 0 });
  });

  it("shows nothing of other work", () => {
    const { loop, feed, wait } = newFeed();
    feed.place(place);
    loop.run();
    wait(3_000);
    feed.place(null);
    expect(feed.take(false)).toMatchObject({ task: 2, maze: null, path: "", tick: 0, line: null });
    wait(3_000);
    expect(feed.take(false)).toBeNull();
  });
});
