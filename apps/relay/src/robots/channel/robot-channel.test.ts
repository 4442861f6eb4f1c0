import { snapshotOf } from "@corridor/protocol/testing";
import { expect, it } from "vitest";
import type { Bus, Channel } from "../../bus/bus.ts";
import { CarriedSnapshot } from "../../bus/carried-snapshot.ts";
import { limits } from "../../platform/limits/limits.ts";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { CoalescedTimers } from "../../platform/time/coalesced-timers.ts";
import { RobotChannel } from "./robot-channel.ts";

const scripts = { connected: 1, client: "Python", silentMs: 0, alive: [], scripts: [] };

function snapshot(seq: number): CarriedSnapshot {
  return CarriedSnapshot.of(snapshotOf({ seq, tick: seq }));
}

/** A channel, and the snapshots that it sends. */
async function withChannel() {
  const clock = new FakeClock();
  const sent: string[] = [];
  const joined: Channel = {
    returnsOwnChanges: false,
    commandsChanged: () => undefined,
    notify: () => undefined,
    sendSnapshot: ({ seq }, relays) => void sent.push(`${seq} to ${[...relays].join()}`),
    flush: () => void sent.push("flush"),
    leave: () => undefined,
  };
  const bus: Bus = { join: async () => joined, close: async () => undefined };
  const channel = new RobotChannel(clock, new CoalescedTimers(clock));
  const ignore = () => undefined;
  await channel.open(bus, "robot", { commandsChanged: ignore, missed: ignore, received: ignore });
  return { clock, channel, sent };
}

it("sends snapshots to the relays that announced themselves, until they are silent", async () => {
  const { clock, channel, sent } = await withChannel();
  channel.snapshot(snapshot(1));
  channel.receivedAnnouncement("a", scripts);
  channel.snapshot(snapshot(2));
  await clock.pass(limits.relaySilenceMs);
  channel.receivedAnnouncement("b", scripts);
  channel.snapshot(snapshot(3));
  await clock.pass(1);
  channel.flush();
  await clock.pass(limits.snapshotIntervalMs);
  channel.snapshot(snapshot(4));
  await clock.pass(limits.relaySilenceMs);
  channel.snapshot(snapshot(5));
  expect(sent).toEqual(["2 to a", "3 to a,b", "flush", "4 to b"]);
});

it("sends only the newest of many snapshots, and that before an ending", async () => {
  const { clock, channel, sent } = await withChannel();
  channel.receivedAnnouncement("a", scripts);
  for (let seq = 1; seq <= 5; seq++) channel.snapshot(snapshot(seq));
  channel.flush();
  await clock.pass(10 * limits.snapshotIntervalMs);
  expect(sent).toEqual(["1 to a", "5 to a", "flush"]);
});
