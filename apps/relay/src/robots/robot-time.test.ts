import { expiredReason } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { completed } from "../platform/testing/messages.ts";
import { LEFT, waitLimit, withRobot, page } from "./testing/robot-at-relay.ts";

describe("a robot session: time to live", () => {
  it("expires what no page takes in time, and tells who waits for its end", async () => {
    const robot = await withRobot();
    await robot.submit({ ...LEFT, ttl: 400 });
    await robot.submit(LEFT);
    const end = robot.session.endOf(1, waitLimit(25_000));
    await robot.clock.pass(399);
    expect(await robot.states()).toEqual(["1 accepted", "2 accepted"]);
    await robot.clock.pass(1);
    expect(await end).toMatchObject({ state: "expired", reason: expiredReason(400) });
    await robot.clock.pass(9_600);
    expect(await robot.states()).toEqual(["1 expired", "2 expired"]);
  });

  it("tells the robot how much time is left, counted from the first try", async () => {
    const robot = await withRobot();
    await robot.submit({ ...LEFT, ttl: 2_000, age: 300 });
    await robot.clock.pass(500);
    const host = await page(robot);
    expect(host.told.find(({ type }) => type === "command")).toMatchObject({
      seq: 1,
      ttl: 2_000,
      remaining: 1_200,
      driver: robot.key.hash.slice(0, 6),
      replace: false,
      lease: null,
    });
    await robot.clock.pass(60_000);
    expect(await robot.states()).toEqual(["1 delivered"]);
    await host.ended({ ...completed(1), state: "expired" });
    expect(await robot.states()).toEqual(["1 expired"]);
  });

  it("refuses a try that comes too late, keeps its key free, and answers a known key at any age", async () => {
    const robot = await withRobot();
    const late = robot.submit({ ...LEFT, ttl: 1_000, age: 1_000 }, "key-0001");
    await expect(late).rejects.toMatchObject({ kind: "too-late" });
    expect(await robot.submit({ ...LEFT, ttl: 1_000 }, "key-0001")).toMatchObject({ seq: 1 });
    await robot.clock.pass(1_500);
    expect(await robot.submit({ ...LEFT, ttl: 1_000, age: 1_500 }, "key-0001")).toMatchObject({
      seq: 1,
      state: "expired",
      duplicate: true,
    });
  });

  it("shows the page what waits for it and how it ends", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    for (let n = 0; n < 9; n++) await robot.submit({ ...LEFT, ttl: 2_000 });
    await robot.clock.pass(2_000);
    const shown = host.told.flatMap((message) =>
      message.type === "state" ? [[message.record.seq, message.record.state, message.ttl]] : [],
    );
    expect(shown).toEqual([
      [9, "accepted", 2_000],
      [9, "expired", 2_000],
    ]);
  });

  it("does not deliver again what has expired while the page was away", async () => {
    const robot = await withRobot();
    const before = await page(robot);
    await robot.submit({ ...LEFT, ttl: 400 });
    await robot.submit(LEFT);
    robot.session.leavePage(before.link, true);
    await robot.clock.pass(500);
    expect(await robot.states()).toEqual(["1 delivered", "2 delivered"]);
    const after = await page(robot);
    expect(after.seqs("command")).toEqual([2]);
    expect(await robot.states()).toEqual(["1 expired", "2 delivered"]);
  });
});
