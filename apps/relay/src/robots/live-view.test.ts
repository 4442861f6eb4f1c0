import { snapshotOf } from "@corridor/protocol/testing";
import { expect, it } from "vitest";
import { CarriedSnapshot } from "../bus/carried-snapshot.ts";
import { limits } from "../platform/limits/limits.ts";
import { FakeClock } from "../platform/testing/fake-clock.ts";
import { LiveView } from "./live-view.ts";

/** A live view, with what readers at this relay and other relays receive. */
function withView() {
  const clock = new FakeClock();
  const readers: string[] = [];
  const relays: string[] = [];
  const inWords = ({ seq, state }: CarriedSnapshot): string => `${seq} ${state}`;
  const view = new LiveView({
    clock,
    subscribers: { publishSnapshot: (snapshot) => void readers.push(inWords(snapshot)) },
    channel: { snapshot: (snapshot) => void relays.push(inWords(snapshot)) },
  });
  const snapshot = (seq: number) => CarriedSnapshot.of(snapshotOf({ seq, tick: seq }));
  return { clock, view, readers, relays, snapshot };
}

it("shows readers at all relays what the page at this relay reports, and that it disconnects", () => {
  const { view, readers, relays, snapshot } = withView();
  view.pageConnected(0);
  view.report(snapshot(1));
  view.pageLeft();
  expect(readers).toEqual(["1 running", "1 gone"]);
  expect(relays).toEqual(readers);
});

it("shows only readers at this relay what the page at another relay reports", () => {
  const { view, readers, relays, snapshot } = withView();
  view.receive(snapshot(1));
  view.pageLeftElsewhere();
  expect(readers).toEqual(["1 running", "1 gone"]);
  expect(relays).toEqual([]);
});

it("shows once that a page is asleep", async () => {
  const { clock, view, readers, relays, snapshot } = withView();
  view.pageConnected(0);
  view.report(snapshot(1));
  await clock.pass(limits.asleepMs);
  view.checkAsleep();
  expect(readers).toEqual(["1 running"]);
  await clock.pass(1);
  for (let n = 0; n < 3; n++) view.checkAsleep();
  expect(readers).toEqual(["1 running", "1 paused"]);
  expect(relays).toEqual(readers);
});

it("shows nothing of a robot that has never reported", () => {
  const { view, readers, relays } = withView();
  view.pageConnected(0);
  view.checkAsleep();
  view.pageLeft();
  view.pageLeftElsewhere();
  expect([...readers, ...relays]).toEqual([]);
});
