import { REVOKED_REASON } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { completed } from "../platform/testing/messages.ts";
import { LEFT, withRobot, page } from "./testing/robot-at-relay.ts";

describe("a robot: replacing and cancelling", () => {
  it("delivers a replacing command immediately, and supersedes the waiting ones", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let n = 0; n < 9; n++) await setup.submit(LEFT);
    await setup.submit({ ...LEFT, replace: true });
    expect(host.sent.at(-1)).toMatchObject({ type: "command", seq: 10, replace: true });
    expect((await setup.states()).slice(7)).toEqual([
      "8 delivered",
      "9 superseded",
      "10 delivered",
    ]);
  });

  it("withdraws a waiting command, and asks the robot to end a delivered one", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let n = 0; n < 9; n++) await setup.submit(LEFT);
    expect(await setup.robot.cancel(setup.caller, 9)).toMatchObject({ state: "cancelled" });
    expect(await setup.robot.cancel(setup.caller, 8)).toMatchObject({ state: "delivered" });
    expect(host.sent.at(-1)).toEqual({ type: "cancel", seq: 8, cause: "sender" });
    await host.ended({ ...completed(8), state: "cancelled" });
    expect(await setup.robot.cancel(setup.caller, 8)).toMatchObject({ state: "cancelled" });
    await expect(setup.robot.cancel(setup.caller, 10)).rejects.toMatchObject({
      kind: "no-command",
    });
    const other = setup.robot.cancel({ kind: "drive", hash: "other" }, 1);
    await expect(other).rejects.toMatchObject({ kind: "forbidden" });
  });
});

describe("a robot: withdrawing commands while the page is disconnected", () => {
  it("does not redeliver a withdrawn command, and asks the page to end a started one", async () => {
    const setup = await withRobot();
    const before = await page(setup);
    for (let n = 0; n < 3; n++) await setup.submit(LEFT);
    await before.started(1);
    setup.robot.page.leave(before.connection, true);
    for (const seq of [1, 2])
      expect(await setup.robot.cancel(setup.caller, seq)).toHaveProperty("seq");
    const after = await page(setup, { lastApplied: 1 });
    expect(after.seqs("command")).toEqual([3]);
    expect(after.sent).toContainEqual({ type: "cancel", seq: 1, cause: "sender" });
    expect(await setup.states()).toEqual(["1 started", "2 cancelled", "3 delivered"]);
    await after.ended({ ...completed(1), state: "cancelled" });
    expect(await setup.states()).toEqual(["1 cancelled", "2 cancelled", "3 delivered"]);
  });

  it("does not redeliver the commands of a revoked key", async () => {
    const setup = await withRobot();
    const before = await page(setup);
    await setup.submit(LEFT);
    setup.robot.page.leave(before.connection, true);
    await setup.robot.keys.make({ kind: "drive", replace: true });
    const after = await page(setup);
    expect(after.seqs("command")).toEqual([]);
    const [record] = await setup.robot.commandsAfter(0);
    expect(record).toMatchObject({ state: "cancelled", reason: REVOKED_REASON });
  });
});
