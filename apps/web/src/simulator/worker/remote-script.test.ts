import { describe, expect, it } from "vitest";
import { firstMaze } from "../protocol/first-project.ts";
import type { RunLoop } from "./run-loop.ts";
import { Bench, deliveryOf } from "./testing/bench.ts";

describe("a remote script", () => {
  it("has its commands run one after the other, each started and ended once", () => {
    const bench = new Bench();
    const { loop } = bench;
    loop.setDriver("remote");
    bench.deliver({ action: "move", distance: 100 });
    bench.deliver({ action: "left 90" });
    bench.deliver({ action: "move", distance: 500 });
    bench.pass(8000);
    expect(bench.story).toEqual([
      "started 1",
      "completed 1",
      "started 2",
      "completed 2",
      "started 3",
      "collided 3",
    ]);
    expect(bench.endings.get(1)?.distance).toBeCloseTo(100, 6);
    expect(bench.endings.get(1)?.pose.x).toBeCloseTo(150, 6);
  });

  it("drives forward until its next command, or until a wall", () => {
    const bench = new Bench();
    const { loop } = bench;
    loop.setDriver("remote");
    bench.deliver({ action: "forward" });
    bench.pass(1000);
    expect(loop.snapshot()).toMatchObject({ command: 1, motion: "forward" });
    bench.deliver({ action: "stop" });
    bench.deliver({ action: "forward" });
    bench.pass(10_000);
    expect(bench.story).toEqual([
      "started 1",
      "completed 1",
      "started 2",
      "completed 2",
      "started 3",
      "collided 3",
    ]);
    expect(loop.snapshot()).toMatchObject({ command: null, motion: "stop", bumping: true });
  });

  it("learns at once that it may not drive while another driver does", () => {
    const bench = new Bench();
    bench.deliver({ action: "forward" });
    expect(bench.endings.get(1)).toMatchObject({ state: "cancelled" });
    expect(bench.endings.get(1)?.reason).toBe("notRemote");
  });

  it.each([
    deliveryOf(1, { action: "drive", left: 0.5, right: 0.5 }, { replace: true }),
    deliveryOf(1, { action: "reset" }),
  ])("does not stop the robot of a user who drives", (delivery) => {
    const bench = new Bench();
    bench.loop.hold("forward");
    bench.pass(200);
    bench.loop.accept(delivery);
    expect(bench.endings.get(1)?.reason).toBe("notRemote");
    bench.pass(100);
    expect(bench.loop.snapshot()).toMatchObject({ driver: "me", motion: "forward" });
  });

  it.each([
    { name: "the user takes over", act: (loop: RunLoop) => loop.hold("forward") },
    { name: "the robot is reset", act: (loop: RunLoop) => loop.reset() },
    { name: "the program is chosen", act: (loop: RunLoop) => loop.setDriver("program") },
    {
      name: "a block falls on the robot",
      act: (loop: RunLoop) =>
        loop.editMaze({
          ...firstMaze,
          blocks: ["...", "...", "..."],
          goals: [],
          start: { column: 0, row: 0, heading: "east" },
        }),
    },
  ])("has every command cancelled when $name", ({ act }) => {
    const bench = new Bench();
    const { loop } = bench;
    loop.setDriver("remote");
    bench.deliver({ action: "move", distance: 200 });
    bench.deliver({ action: "left 90" });
    bench.pass(500);
    act(loop);
    expect(bench.story).toEqual(["started 1", "cancelled 1", "cancelled 2"]);
  });
});

it("a script that reaches the goal and bumps within one frame receives both", () => {
  const corridor = {
    ...firstMaze,
    blocks: ["..."],
    start: { column: 0, row: 0, heading: "east" as const },
    goals: [{ column: 2, row: 0 }],
  };
  const bench = new Bench(corridor);
  const { loop } = bench;
  loop.setDriver("remote");
  loop.setSpeed(16);
  bench.deliver({ action: "forward" });
  bench.time += 240;
  loop.advance();
  const kinds = loop.updates.take()?.events.map(({ kind }) => kind);
  expect(kinds).toEqual(["goal", "bump"]);
});
