import { expect, it } from "vitest";
import { SnapshotThrottle } from "./snapshot-throttle.ts";

/** The milliseconds at which a snapshot is sent, if the robot changes up to a given time. */
function sentUntil(end: number, changesUntil: number): number[] {
  let time = 0;
  const throttle = new SnapshotThrottle(() => time);
  const sent: number[] = [];
  for (; time <= end; time += 10) {
    if (time < changesUntil) throttle.changed();
    if (throttle.take()) sent.push(time);
  }
  return sent;
}

it("a new connection receives a snapshot at once, even of a robot at rest", () => {
  expect(sentUntil(0, 0)).toEqual([0]);
});

it("a robot that changes is sent twenty times a second, one at rest every second", () => {
  expect(sentUntil(2_300, 200)).toEqual([0, 50, 100, 150, 200, 1_200, 2_200]);
});

it("a change while nothing may be sent is not lost", () => {
  let time = 0;
  const throttle = new SnapshotThrottle(() => time);
  expect(throttle.take()).toBe(true);
  throttle.changed();
  expect(throttle.take()).toBe(false);
  time = 50;
  expect(throttle.take()).toBe(true);
  time = 100;
  expect(throttle.take()).toBe(false);
});
