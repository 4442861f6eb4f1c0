import { MAX_SCRIPTS } from "@corridor/protocol";
import { expect, it } from "vitest";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import type { StoredScript } from "../../store/port.ts";
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
