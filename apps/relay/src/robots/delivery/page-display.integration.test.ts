import type { RelayToPage } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { CoalescedTimers } from "../../platform/time/coalesced-timers.ts";
import type { TermedRecord } from "../../commands/robot-commands.ts";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { completed } from "../../platform/testing/messages.ts";
import { limits } from "../../platform/limits/limits.ts";
import { PageDisplay } from "./command-delivery.ts";
import { PageOwnership } from "../page/page-ownership.ts";
import { LEFT, page, withRobot, type Host } from "../testing/robot-at-relay.ts";

const { shownIntervalMs } = limits;
/** Maximum delay of a coalesced timer. */
const SHARED_MS = 5;

function command(seq: number, state: "accepted" | "expired" = "accepted"): TermedRecord {
  const record = {
    seq,
    key: null,
    action: "left 90" as const,
    command: LEFT,
    state,
    reason: null,
    acceptedAt: "2026-01-01T00:00:00.000Z",
    pose: null,
    distance: null,
    duplicate: false,
  };
  const terms = {
    driver: "d",
    script: null,
    ttl: 10_000,
    deadline: 0,
    replace: false,
    lease: null,
  };
  return { record, ...terms };
}

/** Summary of a message, with the seq of a command. */
function inWords(message: RelayToPage): string {
  if (message.type === "state") return `${message.record.seq} ${message.record.state}`;
  return "seq" in message ? `${message.type} ${message.seq}` : message.type;
}

/** A robot's ownership, and pages that acquire it, with the writes that each page received. */
function withOwnership() {
  const clock = new FakeClock();
  const ownership = new PageOwnership(clock.now(), { epoch: 0, page: "" });
  const display = new PageDisplay({ ownership, clock, timers: new CoalescedTimers(clock) });
  let epoch = 0;
  const newPage = (): string[][] => {
    const writes: string[][] = [];
    const connection = {
      isOpen: true,
      send: (...messages: RelayToPage[]) => void writes.push(messages.map(inWords)),
      close: () => undefined,
    };
    epoch += 1;
    ownership.take({ connection, epoch, name: "" });
    return writes;
  };
  return { clock, ownership, display, newPage };
}

describe("the page's display of waiting commands", () => {
  it("is updated immediately if changes are rare", async () => {
    const { clock, display, newPage } = withOwnership();
    const writes = newPage();
    display.show([command(1)]);
    expect(writes).toEqual([["1 accepted"]]);
    await clock.pass(shownIntervalMs);
    display.show([command(2)]);
    expect(writes).toEqual([["1 accepted"], ["2 accepted"]]);
  });

  it("is updated once, a second later and in order, if changes are frequent", async () => {
    const { clock, display, newPage } = withOwnership();
    const writes = newPage();
    display.show([command(1)]);
    await clock.pass(100);
    display.show([command(2), command(3)]);
    await clock.pass(300);
    display.show([command(2, "expired")]);
    display.show([]);
    await clock.pass(shownIntervalMs - 400 - 1);
    expect(writes).toEqual([["1 accepted"]]);
    await clock.pass(1 + SHARED_MS);
    expect(writes).toEqual([["1 accepted"], ["2 accepted", "3 accepted", "2 expired"]]);
    await clock.pass(10 * shownIntervalMs);
    expect(writes).toHaveLength(2);
  });

  it("is updated at most once a second, even if many updates accompany other messages", async () => {
    const { clock, display, newPage } = withOwnership();
    const writes = newPage();
    for (let seq = 1; seq <= 50; seq++) {
      display.show([command(seq)]);
      await clock.pass(50);
      if (seq === 10) display.flush();
    }
    await clock.pass(shownIntervalMs + SHARED_MS);
    // At 0 ms, at 500 ms by the flush, then every second.
    expect(writes).toHaveLength(4);
    expect(writes.flat()).toEqual(Array.from({ length: 50 }, (_, n) => `${n + 1} accepted`));
  });

  it("precedes the messages that it accompanies", () => {
    const { display, newPage } = withOwnership();
    const writes = newPage();
    display.sendWith({ type: "heartbeat" });
    for (const seq of [1, 2, 3]) display.show([command(seq)]);
    display.sendWith({ type: "heartbeat" });
    expect(writes).toEqual([
      ["heartbeat"],
      ["1 accepted"],
      ["2 accepted", "3 accepted", "heartbeat"],
    ]);
  });

  it("does not show the next page an update that was pending for the previous page", async () => {
    const { clock, display, newPage } = withOwnership();
    const before = newPage();
    for (const seq of [1, 2]) display.show([command(seq)]);
    const after = newPage();
    display.show([command(3)]);
    await clock.pass(10 * shownIntervalMs);
    expect(before).toEqual([["1 accepted"]]);
    expect(after).toEqual([["3 accepted"]]);
  });

  it.each([
    { how: "by the timer", flush: () => undefined },
    { how: "before a command is delivered", flush: (display: PageDisplay) => display.flush() },
    {
      how: "with another message",
      flush: (display: PageDisplay) => display.sendWith({ type: "heartbeat" }),
    },
  ])("is discarded if the page is disconnected: $how", async ({ flush }) => {
    const { clock, ownership, display, newPage } = withOwnership();
    const writes = newPage();
    for (const seq of [1, 2]) display.show([command(seq)]);
    ownership.leave(clock.now(), true);
    flush(display);
    display.show([command(3)]);
    await clock.pass(10 * shownIntervalMs);
    expect(writes).toEqual([["1 accepted"]]);
    const next = newPage();
    display.flush();
    expect(next).toEqual([]);
  });
});

describe("a page whose robot has more commands than the window", () => {
  const shown = ({ sent }: Host): string[] => sent.map(inWords).filter((words) => /\d/.test(words));

  it("displays each command as waiting before it receives it, in order", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let n = 0; n < 12; n++) await setup.submit(LEFT);
    expect(shown(host).slice(8)).toEqual(["9 accepted"]);
    for (const seq of [1, 2]) await host.ended(completed(seq));
    expect(shown(host).slice(9)).toEqual([
      "stored 1",
      "10 accepted",
      "11 accepted",
      "12 accepted",
      "command 9",
      "stored 2",
      "command 10",
    ]);
  });

  it("displays the commands that a stop cancelled before it receives the stop", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let n = 0; n < 10; n++) await setup.submit(LEFT);
    await setup.submit({ action: "stop" });
    expect(shown(host).slice(8)).toEqual([
      "9 accepted",
      "10 accepted",
      "9 cancelled",
      "10 cancelled",
      "stop 11",
    ]);
  });

  it("receives the waiting commands before the confirmation of its cancellation, which may cancel all of them", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let n = 0; n < 10; n++) await setup.submit(LEFT);
    await host.ended({ ...completed(1), state: "cancelled" });
    expect(shown(host).slice(8)).toEqual(["9 accepted", "10 accepted", "stored 1", "command 9"]);
  });

  it("displays the waiting commands before its relay closes, and nothing afterwards", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let n = 0; n < 10; n++) await setup.submit(LEFT);
    setup.robot.close("restart");
    expect(shown(host).slice(8)).toEqual(["9 accepted", "10 accepted"]);
    const before = host.sent.length;
    await setup.clock.pass(10 * shownIntervalMs);
    expect(host.sent).toHaveLength(before);
  });

  it("displays the waiting commands together with the scripts when a script is blocked", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let n = 0; n < 10; n++) await setup.submit(LEFT);
    setup.robot.presence.blockedChanged();
    expect(host.sent.map(inWords).slice(-2)).toEqual(["10 accepted", "drivers"]);
  });
});
