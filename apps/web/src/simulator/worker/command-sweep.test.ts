import { describe, expect, it } from "vitest";
import type { RunLoop } from "./run-loop.ts";
import { openRobot } from "./testing/remote-page.ts";

describe("a command that is queued at the relay when the page takes the robot", () => {
  it.each([
    { what: "is handed over", reason: "takenOver", act: (loop: RunLoop) => loop.setDriver("me") },
    { what: "is reset", reason: "reset", act: (loop: RunLoop) => loop.reset() },
  ])("never runs if the robot $what, although Remote drives when it arrives", async (row) => {
    const { relay, loop, states, drive } = await openRobot();
    relay.accept("A", 1);
    relay.wait(2);
    drive(50);
    row.act(loop);
    loop.setDriver("remote");
    relay.accept("A", 2);
    relay.accept("A", 3);
    drive(2_000);
    expect(states()).toEqual([
      [3, "completed", null],
      [2, "cancelled", row.reason],
      [1, "cancelled", row.reason],
    ]);
    const started = relay.received.filter(({ type }) => type === "started");
    expect(started.map(({ seq }) => seq)).toEqual([1, 3]);
  });

  it("never runs even if the relay reports it later, unlike later commands", async () => {
    const { relay, loop, states, drive } = await openRobot();
    relay.accept("A", 1);
    drive(50);
    loop.reset();
    relay.wait(2);
    relay.stored(1);
    relay.wait(3);
    for (const seq of [2, 3]) relay.accept("A", seq);
    drive(2_000);
    expect(states()).toEqual([
      [3, "completed", null],
      [2, "cancelled", "reset"],
      [1, "cancelled", "reset"],
    ]);
  });

  it("runs if it is reported late and the page had not taken the robot", async () => {
    const { relay, loop, states, drive } = await openRobot();
    relay.accept("A", 1);
    loop.cancelRemote("stopped");
    relay.wait(2);
    relay.stored(1);
    relay.accept("A", 2);
    drive(2_000);
    expect(states()[0]).toEqual([2, "completed", null]);
  });

  it("never runs if it was sent while Remote did not drive", async () => {
    const { relay, loop, states, drive } = await openRobot();
    loop.setDriver("me");
    relay.wait(2);
    relay.accept("A", 1);
    loop.setDriver("remote");
    relay.accept("A", 2);
    drive(2_000);
    expect(states()).toEqual([
      [2, "cancelled", "notRemote"],
      [1, "cancelled", "notRemote"],
    ]);
  });

  it("runs after a script's stop, and for another robot", async () => {
    const { relay, open, loop, states, drive } = await openRobot();
    relay.wait(2);
    loop.cancelRemote("stopped");
    relay.accept("A", 2);
    drive(2_000);
    expect(states()).toEqual([[2, "completed", null]]);
    relay.wait(5);
    loop.reset();
    await open(null);
    relay.welcome("B");
    relay.accept("B", 1);
    drive(2_000);
    expect(states()).toEqual([[1, "completed", null]]);
  });
});
