import type { MazeDocument } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { firstMaze } from "./first-project.ts";
import { MazeTeller } from "./maze-teller.ts";

const other = (name: string): MazeDocument => ({ ...firstMaze, name });

/** A robot that reports every 50 ms, at a relay that answers as it is told. */
function telling() {
  let now = 0;
  let maze: MazeDocument | null = null;
  const told: string[] = [];
  const relay = { status: 204, isReachable: true };
  const teller = new MazeTeller({
    now: () => now,
    give: async (text) => {
      if (!relay.isReachable) throw new TypeError("fetch failed");
      told.push((JSON.parse(text) as MazeDocument).name);
      return relay.status;
    },
  });
  const pass = async (ms: number, next?: MazeDocument): Promise<void> => {
    if (next !== undefined) maze = next;
    for (const end = now + ms; now < end; now += 50) {
      teller.offer(maze);
      await Promise.resolve();
      await Promise.resolve();
    }
  };
  return { teller, told, relay, pass };
}

describe("the relay", () => {
  it("is told of the maze once it knows the robot, and not again while it stays the same", async () => {
    const { told, pass } = telling();
    await pass(50, other("first"));
    expect(told).toEqual(["first"]);
    await pass(10_000);
    await pass(10_000, other("first"));
    expect(told).toEqual(["first"]);
  });

  it("is told of a change when the hand that draws rests", async () => {
    const { told, pass } = telling();
    await pass(100, other("first"));
    for (const name of ["a", "b", "c", "d", "e", "f"]) await pass(200, other(name));
    expect(told).toEqual(["first"]);
    await pass(600);
    expect(told).toEqual(["first", "f"]);
  });

  it.each([429, 500, 503, 507])("is told again later when it answers %d", async (status) => {
    const { told, relay, pass } = telling();
    relay.status = status;
    await pass(2_000, other("first"));
    expect(told).toEqual(["first"]);
    relay.status = 204;
    await pass(3_000);
    expect(told).toEqual(["first", "first"]);
    await pass(20_000);
    expect(told).toHaveLength(2);
  });

  it("is told again when it was out of reach, by then of the newest", async () => {
    const { told, relay, pass } = telling();
    relay.isReachable = false;
    await pass(1_000, other("first"));
    await pass(1_000, other("second"));
    relay.isReachable = true;
    await pass(3_000);
    expect(told).toEqual(["second"]);
  });

  it("is not asked again to take what is too large, but takes another one", async () => {
    const { told, relay, pass } = telling();
    relay.status = 413;
    await pass(20_000, other("large"));
    expect(told).toEqual(["large"]);
    relay.status = 204;
    await pass(1_000, other("small"));
    expect(told).toEqual(["large", "small"]);
  });

  it("is told the same maze again for another robot", async () => {
    const { teller, told, pass } = telling();
    await pass(100, other("first"));
    teller.begin();
    await pass(100);
    expect(told).toEqual(["first", "first"]);
  });

  it("is told nothing while there is no maze", async () => {
    const { teller, told } = telling();
    teller.offer(null);
    expect(told).toEqual([]);
  });
});
