import type { Resume } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { completed } from "../platform/testing/messages.ts";
import { settled } from "../platform/testing/fake-clock.ts";
import { because } from "../store/cases/robot-in-store.ts";
import { StoreUnavailableError } from "../platform/errors/store-unavailable.ts";
import { limits } from "../platform/limits/limits.ts";
import type { PageConnection } from "./page/page-ownership.ts";
import { LEFT, page, withRobot, type Setup } from "./testing/robot-at-relay.ts";

const DOUBT = because("taken-over-unsure");
const FIRST = "page-one";
const SECOND = "page-two";

/** A page that received three commands and reported the start of the first. */
async function withBusyPage(setup: Setup, isSilent = false) {
  const host = await page(setup, { page: FIRST }, isSilent);
  for (let n = 0; n < 3; n++) await setup.submit(LEFT);
  await host.started(1);
  return host;
}

/** Connects another, newly loaded page. */
const anotherPage = (setup: Setup) => page(setup, { page: SECOND, fresh: true });

describe("a robot: a second page", () => {
  it("receives the commands that the first page has not started, after that page has reported its own", async () => {
    const setup = await withRobot();
    const first = await withBusyPage(setup, true);
    const coming = anotherPage(setup);
    await settled();
    expect(first.sent.at(-1)).toEqual({ type: "yield" });
    // These reports were in transit when the relay asked the first page.
    await first.started(2);
    await first.ended(completed(1));
    await first.yielded();
    const second = await coming;
    expect(first.closed).toEqual([4409]);
    expect(second.seqs("command")).toEqual([3]);
    expect(await setup.states()).toEqual(["1 completed", "2 cancelled", "3 delivered"]);
  });

  it("receives no command that a silent page may have started", async () => {
    const setup = await withRobot();
    const first = await withBusyPage(setup, true);
    const coming = anotherPage(setup);
    await settled();
    await setup.submit(LEFT);
    expect(first.seqs("command")).toEqual([1, 2, 3]);
    await setup.clock.pass(limits.yieldMs);
    const second = await coming;
    expect(first.closed).toEqual([4409]);
    expect(second.seqs("command")).toEqual([4]);
    const records = await setup.robot.commandsAfter(0);
    expect(records.map(({ state, reason }) => [state, reason])).toEqual([
      ["cancelled", because("taken-over")],
      ["cancelled", DOUBT],
      ["cancelled", DOUBT],
      ["delivered", null],
    ]);
  });

  it("receives the remaining commands of a page that closed its connection, but not of one that lost it", async () => {
    for (const closedByPage of [true, false]) {
      const setup = await withRobot();
      const first = await withBusyPage(setup);
      setup.robot.page.leave(first.connection, closedByPage);
      const second = await anotherPage(setup);
      expect(second.seqs("command")).toEqual(closedByPage ? [2, 3] : []);
    }
  });

  it("ends the commands of a page whose connection was lost, because of the reload", async () => {
    const reasons = async (setup: Setup) =>
      (await setup.robot.commandsAfter(0)).map(({ reason }) => reason);
    const reloaded = because("reloaded-unsure");
    const ended = [because("reloaded"), reloaded, reloaded];
    const setup = await withRobot();
    const first = await withBusyPage(setup);
    setup.robot.page.leave(first.connection, false);
    await anotherPage(setup);
    expect(await reasons(setup)).toEqual(ended);
    // The connection breaks only after the reloaded page has arrived.
    const slow = await withRobot();
    const before = await withBusyPage(slow, true);
    const coming = anotherPage(slow);
    await settled();
    slow.robot.page.leave(before.connection, false);
    await coming;
    expect(await reasons(slow)).toEqual(ended);
  });

  it("receives everything that a page sent before it closed its connection", async () => {
    const setup = await withRobot();
    const first = await withBusyPage(setup);
    const received = first.started(2);
    setup.robot.page.leave(first.connection, true);
    await received;
    expect((await anotherPage(setup)).seqs("command")).toEqual([3]);
  });

  it("does not delay the same page on a new connection, which reports what it has started", async () => {
    const setup = await withRobot();
    await withBusyPage(setup);
    const again = await page(setup, { page: FIRST, lastApplied: 2 });
    expect(again.seqs("command")).toEqual([3]);
    expect(await setup.states()).toEqual(["1 started", "2 started", "3 delivered"]);
  });

  it("is recognised as the same page after a restart of the relay", async () => {
    const setup = await withRobot();
    await withBusyPage(setup);
    const restarted = await setup.restarted();
    const again = await page(restarted, { page: FIRST, lastApplied: 2 });
    expect(again.seqs("command")).toEqual([3]);
    const other = await setup.restarted();
    const second = await anotherPage(other);
    expect(second.seqs("command")).toEqual([]);
    expect(await other.states()).toEqual(["1 cancelled", "2 cancelled", "3 cancelled"]);
  });

  it("leaves the robot to the first page if it disconnects before it acquires the robot", async () => {
    const setup = await withRobot();
    const first = await withBusyPage(setup, true);
    const sent: string[] = [];
    const gone: PageConnection = {
      isOpen: false,
      send: ({ type }) => sent.push(type),
      close: () => undefined,
    };
    const resume: Resume = {
      type: "resume",
      lastApplied: 0,
      fresh: true,
      endings: [],
      page: SECOND,
    };
    const coming = setup.robot.page.acquire(gone, resume);
    await settled();
    await setup.clock.pass(2 * limits.yieldMs);
    await coming;
    expect(sent).toEqual([]);
    // The first page reconnects and continues.
    expect(first.closed).toEqual([1013]);
    setup.robot.page.leave(first.connection, false);
    const again = await page(setup, { page: FIRST, lastApplied: 1 });
    expect(again.seqs("command")).toEqual([2, 3]);
  });

  it("ignores messages of the first page after the store failed during its acquisition", async () => {
    const setup = await withRobot();
    const first = await withBusyPage(setup, true);
    const coming = anotherPage(setup);
    await settled();
    setup.cut.isCut = true;
    await expect(first.started(2)).rejects.toBeInstanceOf(StoreUnavailableError);
    setup.cut.isCut = false;
    expect(first.closed).toEqual([1013]);
    await first.yielded();
    await setup.clock.pass(limits.yieldMs);
    expect((await coming).seqs("command")).toEqual([]);
  });
});
