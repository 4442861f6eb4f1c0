/** What becomes of remote commands in the robot, as it tells the relay. */
import type { Command, DeliveredCommand } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { Bench, deliveryOf } from "../worker/testing/bench.ts";

const MOVE: Command = { action: "move", distance: 100 };

function robot() {
  const bench = new Bench();
  bench.loop.setDriver("remote");
  let seq = 0;
  const deliver = (command: Command, change: Partial<DeliveredCommand> = {}): void =>
    bench.loop.accept(deliveryOf(++seq, command, change));
  return { bench, deliver };
}

describe("a remote command that waits in the robot", () => {
  it("expires when its time is over, and no command behind it waits for that", () => {
    const { bench, deliver } = robot();
    deliver(MOVE);
    deliver(MOVE, { remaining: 400 });
    deliver({ action: "left 90" });
    bench.pass(392);
    expect(bench.story).toEqual(["started 1"]);
    bench.pass(16);
    expect(bench.story).toEqual(["started 1", "expired 2"]);
    bench.pass(3_000);
    expect(bench.story.slice(2)).toEqual(["completed 1", "started 3", "completed 3"]);
  });

  it("expires in a robot that is paused, and does not run when it goes on", () => {
    const { bench, deliver } = robot();
    bench.loop.pause();
    deliver(MOVE, { remaining: 400 });
    bench.pass(500);
    bench.loop.run();
    bench.pass(500);
    expect(bench.story).toEqual(["expired 1"]);
  });

  it("runs on to its end once it has started in time", () => {
    const { bench, deliver } = robot();
    deliver(MOVE, { remaining: 200 });
    bench.pass(2_000);
    expect(bench.story).toEqual(["started 1", "completed 1"]);
  });

  it("is forgotten when it goes back to the relay", () => {
    const { bench, deliver } = robot();
    deliver(MOVE);
    deliver(MOVE);
    bench.pass(100);
    bench.loop.giveBack();
    bench.pass(2_000);
    expect(bench.story).toEqual(["started 1", "completed 1"]);
  });
});

describe("a remote command that replaces", () => {
  it("ends what runs and what waits, and starts at once", () => {
    const { bench, deliver } = robot();
    deliver({ action: "turn", degrees: 720 });
    deliver(MOVE);
    bench.pass(100);
    deliver({ action: "forward" }, { replace: true });
    bench.pass(100);
    expect(bench.story).toEqual(["started 1", "superseded 1", "superseded 2", "started 3"]);
    expect(bench.loop.snapshot()).toMatchObject({ motion: "forward", command: 3 });
  });
});

describe("a remote command that its sender takes back", () => {
  it("stops the robot where it runs", () => {
    const { bench, deliver } = robot();
    deliver({ action: "forward" });
    bench.pass(100);
    bench.loop.takeBack(1);
    bench.pass(100);
    expect(bench.story).toEqual(["started 1", "cancelled 1"]);
    expect(bench.loop.snapshot()).toMatchObject({ motion: "stop", command: null });
  });

  it("leaves the others alone where it waits, and means nothing where it has ended", () => {
    const { bench, deliver } = robot();
    for (let n = 0; n < 3; n++) deliver(MOVE);
    bench.pass(100);
    bench.loop.takeBack(2);
    bench.loop.takeBack(2);
    bench.pass(4_000);
    expect(bench.story).toEqual([
      "started 1",
      "cancelled 2",
      "completed 1",
      "started 3",
      "completed 3",
    ]);
  });
});
