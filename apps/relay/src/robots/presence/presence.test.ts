import { encodeFrame, MAX_BLOCKED_SCRIPTS, MAX_FRAME_BYTES, MAX_SCRIPTS } from "@corridor/protocol";
import { expect, it, vi } from "vitest";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import type { StoredScript } from "../../commands/robot-step.ts";
import { Presence } from "./presence.ts";

const [ANNA, BEN] = ["annas-key", "bens-key"];

function script(driver: string, name: string): StoredScript {
  return { id: `${driver}-${name}`, driver, name, client: "Python" };
}

function withPresence() {
  const clock = new FakeClock();
  const presence = new Presence(clock);
  const alive = (driver: string) =>
    presence.report([]).alive.find((each) => each.driver === driver.slice(0, 6));
  return { clock, presence, alive };
}

it("reports the scripts of one key together: the last activity and the newest connection", async () => {
  const { clock, presence, alive } = withPresence();
  presence.connected(script(ANNA, "first"));
  await clock.pass(2_000);
  presence.connected(script(ANNA, "second"));
  await clock.pass(1_000);
  presence.spoke(script(ANNA, "first"));
  await clock.pass(500);
  expect(alive(ANNA)).toMatchObject({ silentMs: 500, connectionMs: 1_500 });
  expect(presence.report([])).toMatchObject({ connected: 2, silentMs: 500 });
  expect(presence.report([]).scripts.map(({ name, silentMs }) => [name, silentMs])).toEqual([
    ["second", 1_500],
    ["first", 500],
  ]);
});

it("holds no motion for a key that is silent, but still lists its script", async () => {
  const { clock, presence, alive } = withPresence();
  presence.spoke(script(ANNA, "first"));
  await clock.pass(10_500);
  expect(alive(ANNA)).toBeUndefined();
  expect(presence.report([]).scripts).toMatchObject([{ name: "first", silentMs: 10_500 }]);
});

it("lets no key end another one's motion by sending ever new names", async () => {
  const { clock, presence, alive } = withPresence();
  presence.spoke(script(ANNA, "first"));
  await clock.pass(100);
  for (let n = 0; n < 10 * MAX_SCRIPTS; n++) presence.spoke(script(BEN, `name-${n}`));
  expect(alive(ANNA)).toMatchObject({ silentMs: 100 });
  expect(presence.report([]).scripts).toHaveLength(MAX_SCRIPTS);
});

it("reports the newest of several problems after a second, without another message", async () => {
  const { clock, presence } = withPresence();
  const report = vi.fn<() => string | null>(
    () => presence.report([]).scripts[0]?.lastProblem?.detail ?? null,
  );
  presence.onChange(report);
  presence.refused(script(ANNA, "first"), "First.");
  await clock.pass(600);
  presence.refused(script(ANNA, "first"), "Second.");
  presence.refused(script(ANNA, "first"), "Third.");
  await clock.pass(5_000);
  expect(report.mock.results.map(({ value }) => value)).toEqual(["First.", "Third."]);
});

it("reports the longest names and problems of all scripts in one message", () => {
  const { clock, presence } = withPresence();
  const names = Array.from({ length: MAX_SCRIPTS + MAX_BLOCKED_SCRIPTS }, (_, n) => ({
    id: String(n).padStart(8, "0"),
    driver: String(n).padStart(43, "k"),
    name: "\u{1f9ed}".repeat(40),
    client: "JavaScript",
  }));
  for (const each of names) presence.refused(each, "x".repeat(1_000));
  const report = presence.report(names.slice(0, MAX_BLOCKED_SCRIPTS));
  const message = {
    type: "drivers",
    at: clock.now(),
    paused: false,
    mayReset: true,
    ...report,
  } as const;
  expect(report.scripts).toHaveLength(MAX_SCRIPTS + MAX_BLOCKED_SCRIPTS);
  expect(encodeFrame(message).length).toBeLessThan(MAX_FRAME_BYTES);
});
