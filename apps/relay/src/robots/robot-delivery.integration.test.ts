import { closeReasons, termsOf, type RelayToPage, type Resume } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { completed } from "../platform/testing/messages.ts";
import { limits } from "../platform/limits/limits.ts";
import type { PageConnection } from "./page/page-ownership.ts";
import { ignoringReader, LEFT, withRobot, page } from "./testing/robot-at-relay.ts";

describe("a robot: delivery", () => {
  it("queues commands until the page connects, then delivers eight at a time, in order", async () => {
    const setup = await withRobot();
    for (let n = 0; n < 10; n++) await setup.submit(LEFT);
    const host = await page(setup);
    expect(host.seqs("command")).toEqual([1, 2, 3, 4, 5, 6, 7, 8]);
    await host.started(1);
    await host.ended(completed(1));
    await host.ended(completed(2));
    expect(host.seqs("command")).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
  });

  it("delivers nothing to a page that disconnected while it acquired the robot, and everything to the next", async () => {
    const setup = await withRobot();
    await setup.submit(LEFT);
    const sent: RelayToPage[] = [];
    let isOpen = true;
    const connection: PageConnection = {
      get isOpen() {
        return isOpen;
      },
      send: (...messages) => sent.push(...messages),
      close: () => undefined,
    };
    const nothing: Resume = { type: "resume", lastApplied: 0, fresh: false, endings: [] };
    const taken = setup.robot.page.acquire(connection, nothing);
    isOpen = false;
    setup.robot.page.leave(connection, true);
    await taken;
    expect(setup.robot.hasPage).toBe(false);
    expect(sent.filter(({ type }) => type === "command")).toEqual([]);
    expect(await setup.states()).toEqual(["1 accepted"]);
    const host = await page(setup);
    expect(host.seqs("command")).toEqual([1]);
  });

  it("sends the page the relay's time, so that the page can measure the delay of a frame", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    await setup.robot.page.receive(host.connection, { type: "time", epoch: host.epoch });
    const welcome = host.sent.find(({ type }) => type === "welcome");
    expect(host.sent.at(-1)).toEqual({ type: "time", at: (welcome as { at: number }).at });
  });

  it("acknowledges a command before it sends any other message about it", async () => {
    const setup = await withRobot();
    await page(setup);
    const said: string[] = [];
    setup.robot.readers.join(
      setup.caller,
      {
        snapshot: () => undefined,
        state: ({ record }) => said.push(record.state),
        ...ignoringReader,
      },
      null,
    );
    await setup.robot.submit(setup.caller, { key: null, ...termsOf(LEFT) }, ({ state }) =>
      said.push(`ack ${state}`),
    );
    expect(said).toEqual(["ack accepted", "delivered"]);
  });

  it("delivers the commands that a reconnecting page has not started, after it accepts the page's endings", async () => {
    const setup = await withRobot();
    for (let n = 0; n < 3; n++) await setup.submit(LEFT);
    const before = await page(setup);
    await before.started(1);
    setup.robot.page.leave(before.connection, true);
    const after = await page(setup, { lastApplied: 2, endings: [completed(1)] });
    expect(after.seqs("command")).toEqual([3]);
    expect(after.sent).toContainEqual({ type: "stored", seq: 1 });
    expect(await setup.states()).toEqual(["1 completed", "2 started", "3 delivered"]);
  });

  it("disconnects the previous page and rejects its later messages", async () => {
    const setup = await withRobot();
    await setup.submit(LEFT);
    const first = await page(setup);
    const second = await page(setup);
    expect(first.closed).toEqual([closeReasons.replaced.code]);
    expect(second.epoch).toBe(first.epoch + 1);
    await first.started(1);
    setup.robot.page.leave(first.connection, true);
    expect(await setup.states()).toEqual(["1 delivered"]);
    await setup.robot.page.receive(second.connection, {
      type: "started",
      epoch: first.epoch,
      seq: 1,
    });
    expect(second.closed).toEqual([closeReasons.replaced.code]);
    expect(await setup.states()).toEqual(["1 delivered"]);
  });

  it("delivers a stop immediately, even if the window is full", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let n = 0; n < 10; n++) await setup.submit(LEFT);
    await setup.submit({ action: "stop" });
    expect(host.seqs("stop")).toEqual([11]);
    expect((await setup.states()).slice(7)).toEqual([
      "8 delivered",
      "9 cancelled",
      "10 cancelled",
      "11 delivered",
    ]);
  });

  it("ends running commands after the page was disconnected for two minutes, and reports that", async () => {
    const setup = await withRobot();
    await setup.submit(LEFT);
    const host = await page(setup);
    await host.started(1);
    setup.robot.page.leave(host.connection, true);
    await setup.clock.pass(limits.pageDisconnectedMs - 2_000);
    expect(await setup.states()).toEqual(["1 started"]);
    await setup.clock.pass(5_000);
    expect(await setup.states()).toEqual(["1 cancelled"]);
    const late = await page(setup, { lastApplied: 1, endings: [completed(1)] });
    const { sent } = late;
    expect(sent.find(({ type }) => type === "refused")).toMatchObject({
      record: {
        seq: 1,
        state: "cancelled",
        reason:
          "The robot disconnected. Check that its page is open and connected under Remote, then send a new command.",
      },
    });
    expect(sent.some(({ type }) => type === "stored")).toBe(false);
    expect(await setup.states()).toEqual(["1 cancelled"]);
  });
});
