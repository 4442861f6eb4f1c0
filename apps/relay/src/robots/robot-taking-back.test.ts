import { REVOKED_REASON } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { completed } from "../platform/testing/messages.ts";
import { LEFT, withRobot, page } from "./testing/robot-at-relay.ts";

describe("a robot session: replacing and cancelling", () => {
  it("gives the page at once what replaces, and supersedes what waits", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    for (let n = 0; n < 9; n++) await robot.submit(LEFT);
    await robot.submit({ ...LEFT, replace: true });
    expect(host.told.at(-1)).toMatchObject({ type: "command", seq: 10, replace: true });
    expect((await robot.states()).slice(7)).toEqual([
      "8 delivered",
      "9 superseded",
      "10 delivered",
    ]);
  });

  it("takes back what waits, and asks the robot for what it has", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    for (let n = 0; n < 9; n++) await robot.submit(LEFT);
    expect(await robot.session.cancel(robot.key, 9)).toMatchObject({ state: "cancelled" });
    expect(await robot.session.cancel(robot.key, 8)).toMatchObject({ state: "delivered" });
    expect(host.told.at(-1)).toEqual({ type: "cancel", seq: 8, cause: "sender" });
    await host.ended({ ...completed(8), state: "cancelled" });
    expect(await robot.session.cancel(robot.key, 8)).toMatchObject({ state: "cancelled" });
    await expect(robot.session.cancel(robot.key, 10)).rejects.toMatchObject({ kind: "no-command" });
    const other = robot.session.cancel({ kind: "drive", hash: "other" }, 1);
    await expect(other).rejects.toMatchObject({ kind: "forbidden" });
  });
});

describe("a robot session: taking back while the page is away", () => {
  it("does not deliver again what was taken back, and asks for what has begun", async () => {
    const robot = await withRobot();
    const before = await page(robot);
    for (let n = 0; n < 3; n++) await robot.submit(LEFT);
    await before.started(1);
    robot.session.leavePage(before.link, true);
    for (const seq of [1, 2])
      expect(await robot.session.cancel(robot.key, seq)).toHaveProperty("seq");
    const after = await page(robot, { lastApplied: 1 });
    expect(after.seqs("command")).toEqual([3]);
    expect(after.told).toContainEqual({ type: "cancel", seq: 1, cause: "sender" });
    expect(await robot.states()).toEqual(["1 started", "2 cancelled", "3 delivered"]);
    await after.ended({ ...completed(1), state: "cancelled" });
    expect(await robot.states()).toEqual(["1 cancelled", "2 cancelled", "3 delivered"]);
  });

  it("does not deliver again what a revoked key had sent", async () => {
    const robot = await withRobot();
    const before = await page(robot);
    await robot.submit(LEFT);
    robot.session.leavePage(before.link, true);
    await robot.session.keys.make({ kind: "drive", replace: true });
    const after = await page(robot);
    expect(after.seqs("command")).toEqual([]);
    const [record] = await robot.session.commandsAfter(0);
    expect(record).toMatchObject({ state: "cancelled", reason: REVOKED_REASON });
  });
});
