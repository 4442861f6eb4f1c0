import { closeReasons } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { StoreUnavailableError } from "../platform/errors/store-unavailable.ts";
import { limits } from "../platform/limits/limits.ts";
import { LEFT, withRobot, page } from "./testing/robot-at-relay.ts";

describe("a robot: while its store is unavailable", () => {
  it("expires commands late if it could not expire them in time", async () => {
    const setup = await withRobot();
    await setup.submit({ ...LEFT, ttl: 400 });
    setup.cut.isCut = true;
    await setup.clock.pass(2_000);
    setup.cut.isCut = false;
    await setup.clock.pass(limits.storeRetryMs);
    expect(await setup.states()).toEqual(["1 expired"]);
  });

  it("ends running commands without a page later", async () => {
    const setup = await withRobot();
    await setup.submit(LEFT);
    const host = await page(setup);
    await host.started(1);
    setup.robot.page.leave(host.connection, true);
    setup.cut.isCut = true;
    await setup.clock.pass(limits.pageDisconnectedMs + 5_000);
    setup.cut.isCut = false;
    await setup.clock.pass(2_000);
    expect(await setup.states()).toEqual(["1 cancelled"]);
  });

  it("delivers a command that was stored although the response was lost, to the page that it had disconnected", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    setup.cut.losesAnswers = true;
    await expect(setup.submit(LEFT, "key-0001")).rejects.toBeInstanceOf(StoreUnavailableError);
    setup.cut.losesAnswers = false;
    // The command may be marked as delivered but was not sent. Only a new connection of the page
    // resolves that.
    expect([host.seqs("command"), host.closed]).toEqual([[], [closeReasons.busy.code]]);
    setup.robot.page.leave(host.connection, true);
    expect(await setup.submit(LEFT, "key-0001")).toMatchObject({ seq: 1, duplicate: true });
    const back = await page(setup);
    expect(back.seqs("command")).toEqual([1]);
  });

  it("delivers a command that was stored without a page, even if no script retries", async () => {
    const setup = await withRobot();
    setup.cut.losesAnswers = true;
    await expect(setup.submit(LEFT)).rejects.toBeInstanceOf(StoreUnavailableError);
    setup.cut.losesAnswers = false;
    await setup.clock.pass(limits.storeRetryMs);
    const host = await page(setup);
    expect(host.seqs("command")).toEqual([1]);
  });
});
