import type { MazeDocument } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { firstMaze } from "../protocol/first-project.ts";
import { MazePublisher } from "./maze-publisher.ts";

const other = (name: string): MazeDocument => ({ ...firstMaze, name });

/** A robot that reports every 50 ms, at a relay with configurable answers. */
function newPublisher() {
  let now = 0;
  let maze: MazeDocument | null = null;
  const published: string[] = [];
  const relay = { status: 204, isReachable: true };
  const publisher = new MazePublisher({
    now: () => now,
    put: async (text) => {
      if (!relay.isReachable) throw new TypeError("fetch failed");
      published.push((JSON.parse(text) as MazeDocument).name);
      return relay.status;
    },
  });
  const pass = async (ms: number, next?: MazeDocument): Promise<void> => {
    if (next !== undefined) maze = next;
    for (const end = now + ms; now < end; now += 50) {
      publisher.offer(maze);
      await Promise.resolve();
      await Promise.resolve();
    }
  };
  return { publisher, published, relay, pass };
}

describe("the published maze", () => {
  it("is sent once the relay knows the robot, and not again while it stays the same", async () => {
    const { published, pass } = newPublisher();
    await pass(50, other("first"));
    expect(published).toEqual(["first"]);
    await pass(10_000);
    await pass(10_000, other("first"));
    expect(published).toEqual(["first"]);
  });

  it("is sent after the last change of a stroke", async () => {
    const { published, pass } = newPublisher();
    await pass(100, other("first"));
    for (const name of ["a", "b", "c", "d", "e", "f"]) await pass(200, other(name));
    expect(published).toEqual(["first"]);
    await pass(600);
    expect(published).toEqual(["first", "f"]);
  });

  it.each([429, 500, 503, 507])("is sent again later if the relay answers %d", async (status) => {
    const { published, relay, pass } = newPublisher();
    relay.status = status;
    await pass(2_000, other("first"));
    expect(published).toEqual(["first"]);
    relay.status = 204;
    await pass(3_000);
    expect(published).toEqual(["first", "first"]);
    await pass(20_000);
    expect(published).toHaveLength(2);
  });

  it("is sent again after the relay was unreachable, by then the newest", async () => {
    const { published, relay, pass } = newPublisher();
    relay.isReachable = false;
    await pass(1_000, other("first"));
    await pass(1_000, other("second"));
    relay.isReachable = true;
    await pass(3_000);
    expect(published).toEqual(["second"]);
  });

  it("is not sent again if it is too large, but another one is", async () => {
    const { published, relay, pass } = newPublisher();
    relay.status = 413;
    await pass(20_000, other("large"));
    expect(published).toEqual(["large"]);
    relay.status = 204;
    await pass(1_000, other("small"));
    expect(published).toEqual(["large", "small"]);
  });

  it("is sent again for another robot", async () => {
    const { publisher, published, pass } = newPublisher();
    await pass(100, other("first"));
    publisher.begin();
    await pass(100);
    expect(published).toEqual(["first", "first"]);
  });

  it("is not sent while there is none", async () => {
    const { publisher, published } = newPublisher();
    publisher.offer(null);
    expect(published).toEqual([]);
  });
});
