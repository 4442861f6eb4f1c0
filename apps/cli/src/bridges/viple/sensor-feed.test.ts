import { describe, expect, it } from "vitest";
import { ManualTimers } from "@corridor/protocol/testing";
import { SensorFeed } from "./sensor-feed.ts";

function feed() {
  const timers = new ManualTimers();
  const startedAt = timers.now();
  const sent: [ms: number, text: string][] = [];
  const sensors = new SensorFeed(timers, (text) => sent.push([timers.now() - startedAt, text]));
  return { timers, sent, sensors };
}

describe("the feed of readings", () => {
  it("sends nothing before the robot reports", async () => {
    const { timers, sent } = feed();
    await timers.pass(1_000);
    expect(sent).toEqual([]);
  });

  it("sends a change at once, and the same again every 250 ms", async () => {
    const { timers, sent, sensors } = feed();
    sensors.update("a");
    await timers.pass(600);
    sensors.update("a");
    sensors.update("b");
    await timers.pass(300);
    expect(sent).toEqual([
      [0, "a"],
      [250, "a"],
      [500, "a"],
      [600, "b"],
      [850, "b"],
    ]);
  });

  it("sends at most 20 a second, and the newest", async () => {
    const { timers, sent, sensors } = feed();
    for (let ms = 0; ms < 1_000; ms += 10) {
      sensors.update(String(ms));
      await timers.pass(10);
    }
    await timers.pass(50);
    expect(sent.length).toBeLessThanOrEqual(21);
    expect(sent.at(-1)).toEqual([1_000, "990"]);
  });

  it("sends nothing after it was closed", async () => {
    const { timers, sent, sensors } = feed();
    sensors.update("a");
    sensors.close();
    await timers.pass(1_000);
    expect(sent).toEqual([]);
  });
});
