import { expiredReason } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { completed } from "../platform/testing/messages.ts";
import { LEFT, waitLimit, withRobot, page } from "./testing/robot-at-relay.ts";

describe("a robot: time to live", () => {
  it("expires commands that no page receives in time, and notifies waiting requests", async () => {
    const setup = await withRobot();
    await setup.submit({ ...LEFT, ttl: 400 });
    await setup.submit(LEFT);
    const end = setup.robot.endOf(1, waitLimit(25_000));
    await setup.clock.pass(399);
    expect(await setup.states()).toEqual(["1 accepted", "2 accepted"]);
    await setup.clock.pass(1);
    expect(await end).toMatchObject({ state: "expired", reason: expiredReason(400, "absent") });
    await setup.clock.pass(9_600);
    expect(await setup.states()).toEqual(["1 expired", "2 expired"]);
  });

  it("sends the robot the remaining time, counted from the first attempt", async () => {
    const setup = await withRobot();
    await setup.submit({ ...LEFT, ttl: 2_000, age: 300 });
    await setup.clock.pass(500);
    const host = await page(setup);
    expect(host.sent.find(({ type }) => type === "command")).toMatchObject({
      seq: 1,
      ttl: 2_000,
      remaining: 1_200,
      driver: setup.caller.hash.slice(0, 6),
      replace: false,
      lease: null,
    });
    await setup.clock.pass(60_000);
    expect(await setup.states()).toEqual(["1 delivered"]);
    await host.ended({ ...completed(1), state: "expired" });
    expect(await setup.states()).toEqual(["1 expired"]);
  });

  it("rejects an attempt that is too late without using its key, and answers a known key at any age", async () => {
    const setup = await withRobot();
    const late = setup.submit({ ...LEFT, ttl: 1_000, age: 1_000 }, "key-0001");
    await expect(late).rejects.toMatchObject({ kind: "too-late" });
    expect(await setup.submit({ ...LEFT, ttl: 1_000 }, "key-0001")).toMatchObject({ seq: 1 });
    await setup.clock.pass(1_500);
    expect(await setup.submit({ ...LEFT, ttl: 1_000, age: 1_500 }, "key-0001")).toMatchObject({
      seq: 1,
      state: "expired",
      duplicate: true,
    });
  });

  it("shows the page its waiting commands and how they end", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let n = 0; n < 9; n++) await setup.submit({ ...LEFT, ttl: 2_000 });
    await setup.clock.pass(2_000);
    const shown = host.sent.flatMap((message) =>
      message.type === "state" ? [[message.record.seq, message.record.state, message.ttl]] : [],
    );
    expect(shown).toEqual([
      [9, "accepted", 2_000],
      [9, "expired", 2_000],
    ]);
  });

  it("does not redeliver a command that expired while the page was disconnected", async () => {
    const setup = await withRobot();
    const before = await page(setup);
    await setup.submit({ ...LEFT, ttl: 400 });
    await setup.submit(LEFT);
    setup.robot.page.leave(before.connection, true);
    await setup.clock.pass(500);
    expect(await setup.states()).toEqual(["1 delivered", "2 delivered"]);
    const after = await page(setup);
    expect(after.seqs("command")).toEqual([2]);
    expect(await setup.states()).toEqual(["1 expired", "2 delivered"]);
  });
});
