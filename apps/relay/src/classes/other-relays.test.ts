import { expect, it } from "vitest";
import type { ClassMessage, ClassPresence } from "../bus/class-message.ts";
import { limits } from "../platform/limits/limits.ts";
import { FakeClock } from "../platform/testing/fake-clock.ts";
import { tile } from "../testing/class-at-relay.ts";
import { OtherRelays } from "./other-relays.ts";

const nobody: ClassPresence = { students: [], watched: [], dashboards: 0, screens: 0 };
const withDashboard = { ...nobody, dashboards: 1 };
const withStudent = { ...nobody, students: [{ student: 7, connectedAt: 1 }] };

function othersOf() {
  const clock = new FakeClock();
  const sent: ClassMessage[] = [];
  const changed: number[][] = [];
  const others = new OtherRelays({
    clock,
    notify: (message) => void sent.push(message),
    presence: () => nobody,
    changed: (students) => void changed.push([...students]),
  });
  return { clock, sent, changed, others };
}

it("announces at once, then at most once in an interval, and again later", async () => {
  const { clock, sent, others } = othersOf();
  for (let n = 0; n < 3; n++) others.announce(n === 2);
  expect(sent).toMatchObject([{ kind: "here", asks: false }]);
  await clock.pass(limits.classRelayIntervalMs);
  expect(sent).toMatchObject([{ asks: false }, { asks: true }]);
  await clock.pass(limits.relayHereMs);
  expect(sent).toHaveLength(3);
});

it("sends the newest tile of each student, and only to dashboards", async () => {
  const { clock, sent, others } = othersOf();
  others.tile(1, tile);
  expect(sent).toEqual([]);
  others.received(withDashboard, "b");
  for (const seq of [2, 3, 4]) others.tile(1, { ...tile, seq });
  await clock.pass(limits.classRelayIntervalMs);
  expect(sent).toMatchObject([
    { kind: "tiles", tiles: [{ student: 1, tile: { seq: 2 } }] },
    { kind: "tiles", tiles: [{ student: 1, tile: { seq: 4 } }] },
  ]);
});

it("counts students of a relay as disconnected once it does not announce them any more", async () => {
  const { clock, changed, others } = othersOf();
  others.announce();
  others.received(withStudent, "b");
  expect(others.isConnected(7)).toBe(true);
  await clock.pass(limits.relaySilenceMs + limits.relayHereMs);
  expect([others.isConnected(7), others.isEmpty]).toEqual([false, true]);
  expect(changed).toEqual([[7], [7]]);
});

it("announces nobody when it leaves, and nothing afterwards", async () => {
  const { clock, sent, others } = othersOf();
  others.announce();
  others.announce();
  others.leave();
  await clock.pass(limits.relayHereMs);
  expect(sent).toMatchObject([{ kind: "here" }, { kind: "here", presence: nobody }]);
});
