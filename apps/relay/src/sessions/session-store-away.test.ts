import { describe, expect, it } from "vitest";
import { StoreAway } from "../store/store-away.ts";
import { limits } from "./limits.ts";
import { LEFT, withRobot, page } from "./testing/robot-at-relay.ts";

describe("a robot session: while its store does not answer", () => {
  it("expires late what it could not expire in time", async () => {
    const robot = await withRobot();
    await robot.submit({ ...LEFT, ttl: 400 });
    robot.cut.isCut = true;
    await robot.clock.pass(2_000);
    robot.cut.isCut = false;
    await robot.clock.pass(limits.storeRetryMs);
    expect(await robot.states()).toEqual(["1 expired"]);
  });

  it("ends later what runs without a page", async () => {
    const robot = await withRobot();
    await robot.submit(LEFT);
    const host = await page(robot);
    await host.started(1);
    robot.session.leavePage(host.link);
    robot.cut.isCut = true;
    await robot.clock.pass(limits.pageAwayMs + 5_000);
    robot.cut.isCut = false;
    await robot.clock.pass(2_000);
    expect(await robot.states()).toEqual(["1 cancelled"]);
  });

  it("delivers what was stored although the answer was lost, at the next try", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    robot.cut.losesAnswers = true;
    await expect(robot.submit(LEFT, "key-0001")).rejects.toBeInstanceOf(StoreAway);
    robot.cut.losesAnswers = false;
    expect(await robot.submit(LEFT, "key-0001")).toMatchObject({ seq: 1, duplicate: true });
    expect(host.seqs("command")).toEqual([1]);
  });

  it("delivers it also where nobody tries again", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    robot.cut.losesAnswers = true;
    await expect(robot.submit(LEFT)).rejects.toBeInstanceOf(StoreAway);
    robot.cut.losesAnswers = false;
    await robot.clock.pass(limits.storeRetryMs);
    expect(host.seqs("command")).toEqual([1]);
  });
});
