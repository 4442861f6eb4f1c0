import type { RelayToPage } from "@corridor/protocol";
import { expect, it } from "vitest";
import type { BusMessage } from "../bus/bus.ts";
import { LocalBus } from "../bus/local.ts";
import { limits } from "../platform/limits/limits.ts";
import { FakeClock } from "../platform/testing/fake-clock.ts";
import { CoalescedTimers } from "../platform/time/coalesced-timers.ts";
import type { StoredScript } from "../commands/robot-step.ts";
import { Presence } from "./presence/presence.ts";
import { RobotChannel } from "./channel/robot-channel.ts";
import { ScriptReport } from "./script-report.ts";

function script(name: string): StoredScript {
  return { id: name, driver: "key", name, client: "Python" };
}

/** A robot at this relay, and what its page and another relay receive. */
async function withReport({ isElsewhere = false } = {}) {
  const clock = new FakeClock();
  const bus = new LocalBus();
  const atOther: BusMessage[] = [];
  const none = { commandsChanged: () => undefined, missed: () => undefined };
  const other = await bus.join("robot", {
    ...none,
    received: (message) => void atOther.push(message),
  });
  const channel = new RobotChannel(clock, new CoalescedTimers(clock));
  await channel.open(bus, "robot", {
    ...none,
    received: (message) => {
      if (message.kind === "here") channel.receivedAnnouncement("other", message.scripts);
    },
  });
  const presence = new Presence(clock);
  const toPage: RelayToPage[] = [];
  const access = { blocked: [] as StoredScript[], isPaused: false, mayReset: true };
  const display = { sendWith: (message: RelayToPage) => void toPage.push(message) };
  const ownership = { isElsewhere };
  const report = new ScriptReport({ clock, presence, access, channel, ownership, display });
  return { clock, presence, access, report, toPage, atOther, other };
}

it("shows the page the scripts of this relay and of others, blocked ones and the pause", async () => {
  const { presence, access, report, toPage, other } = await withReport();
  const elsewhere = new Presence(new FakeClock());
  elsewhere.connected(script("there"));
  other.notify({ kind: "here", from: "other", scripts: elsewhere.report([]), asks: false });
  access.blocked = [script("blocked")];
  access.isPaused = true;
  presence.connected(script("here"));
  expect(toPage).toMatchObject([{ type: "drivers", connected: 2, paused: true }]);
  expect(report.scripts.map(({ id, isBlocked }) => [id, isBlocked])).toEqual([
    ["blocked", true],
    ["here", false],
    ["there", false],
  ]);
});

it("announces only its own scripts to the relay of the page", async () => {
  const { presence, toPage, atOther } = await withReport({ isElsewhere: true });
  presence.connected(script("here"));
  expect(toPage).toEqual([]);
  expect(atOther).toMatchObject([{ kind: "here", asks: false, scripts: { connected: 1 } }]);
});

it("repeats the announcement at intervals, and only while the page is at another relay", async () => {
  for (const isElsewhere of [true, false]) {
    const { clock, report, atOther } = await withReport({ isElsewhere });
    for (let n = 0; n < 2; n++) report.repeatAnnouncement();
    await clock.pass(limits.relayHereMs);
    report.repeatAnnouncement();
    expect(atOther).toHaveLength(isElsewhere ? 2 : 0);
  }
});
