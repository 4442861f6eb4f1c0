import { closeReasons } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { StoreAway } from "../platform/errors/store-away.ts";
import { limits } from "../platform/limits/limits.ts";
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
    robot.session.leavePage(host.link, true);
    robot.cut.isCut = true;
    await robot.clock.pass(limits.pageAwayMs + 5_000);
    robot.cut.isCut = false;
    await robot.clock.pass(2_000);
    expect(await robot.states()).toEqual(["1 cancelled"]);
  });

  it("delivers what was stored although the answer was lost, to the page that it sent away", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    robot.cut.losesAnswers = true;
    await expect(robot.submit(LEFT, "key-0001")).rejects.toBeInstanceOf(StoreAway);
    robot.cut.losesAnswers = false;
    // The command may be marked as delivered but was not sent. Only a new connection of the page
    // resolves that.
    expect([host.seqs("command"), host.closed]).toEqual([[], [closeReasons.busy.code]]);
    robot.session.leavePage(host.link, true);
    expect(await robot.submit(LEFT, "key-0001")).toMatchObject({ seq: 1, duplicate: true });
    const back = await page(robot);
    expect(back.seqs("command")).toEqual([1]);
  });

  it("delivers what was stored for a page that was not there, where nobody tries again", async () => {
    const robot = await withRobot();
    robot.cut.losesAnswers = true;
    await expect(robot.submit(LEFT)).rejects.toBeInstanceOf(StoreAway);
    robot.cut.losesAnswers = false;
    await robot.clock.pass(limits.storeRetryMs);
    const host = await page(robot);
    expect(host.seqs("command")).toEqual([1]);
  });
});
