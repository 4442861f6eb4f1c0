/** Page and script behind filters that break WebSockets, with a real relay. */
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { globalPlatform, type Platform } from "../../../packages/client/src/platform.ts";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { RobotClient } from "../../../packages/client/src/robot-client.ts";
import type { FilterMode } from "../../support/client/filter-proxy.ts";
import type { RelayProcess } from "../../support/relay-process.ts";
import { startFilterProxy } from "../../support/client/start-filter-proxy.ts";
import { GridRobot } from "../../support/client/grid-robot.ts";
import { sharedRelayProcess, startRelayProcess } from "../../support/test-relay-process.ts";

const CORRIDOR = ["#".repeat(42), `#${".".repeat(40)}#`, "#".repeat(42)];

const sharedRelay = sharedRelayProcess();

async function behind(
  mode: FilterMode,
  { own, platform }: { own?: RelayProcess; platform?: Platform } = {},
) {
  const relay = own ?? (await sharedRelay());
  const proxy = await startFilterProxy(relay.url, mode);
  const registration = await registerRobot(proxy.origin, fetch);
  const robot = new GridRobot(proxy.origin, registration, CORRIDOR);
  onTestFinished(() => robot.connection.close());
  const address = `${proxy.origin}/r/${registration.id}#${registration.driverKey}`;
  // A busy machine needs more than the default of 10 s to restart a relay.
  const options = { ttl: 60_000, ...(platform !== undefined && { platform }) };
  const script = await RobotClient.connect(address, options);
  onTestFinished(() => script.close());
  return { proxy, robot, script };
}

const modes: FilterMode[] = [
  "stripped",
  "blocked",
  "silent",
  "cut early",
  "impatient",
  "buffering",
];

describe("behind a filter", () => {
  it.each(modes)(
    "page and script connect, and no command is lost or duplicated: %s",
    async (mode) => {
      const { proxy, robot, script } = await behind(mode);
      await script.right90();
      for (let n = 0; n < 20; n++) {
        const { seq, state } = await script.move(100);
        expect([seq, state]).toEqual([n + 2, "completed"]);
      }
      expect((await script.sensors()).front).toBe(1_950);
      expect(await script.stop()).toMatchObject({ state: "completed" });
      expect(robot.done).toHaveLength(21);
      expect(proxy.upgrades > 0).toBe(mode === "cut early" || mode === "impatient");
      // Silence, in which some filters cut the connection.
      const minCuts = proxy.cuts + (mode === "cut early" || mode === "impatient" ? 1 : 0);
      await expect.poll(() => proxy.cuts, { timeout: 20_000 }).toBeGreaterThanOrEqual(minCuts);
      expect(await script.move(100)).toMatchObject({ state: "completed" });
      expect(robot.done).toHaveLength(22);
    },
  );

  it("they resume by long polling after the relay was killed", async () => {
    const relay = await startRelayProcess();
    const { robot, script } = await behind("blocked", { own: relay });
    await script.right90();
    const records: Promise<{ seq: number }>[] = [];
    for (let n = 0; n < 20; n++) records.push(script.move(100));
    await records[3];
    await relay.killAndRestart();
    const all = await Promise.all(records);
    expect(all.map(({ seq }) => seq)).toEqual(all.map((_record, index) => index + 2));
    expect(robot.done).toHaveLength(21);
  });

  it("a script in Node 20, which has no WebSocket, drives by long polling", async () => {
    vi.stubGlobal("WebSocket", undefined);
    onTestFinished(() => void vi.unstubAllGlobals());
    const { proxy, script } = await behind("none");
    expect(await script.right90()).toMatchObject({ state: "completed" });
    expect(await script.move(100)).toMatchObject({ state: "completed" });
    expect(proxy.upgrades).toBe(0);
  });

  it("they return to WebSockets once the filter is gone", async () => {
    const real = globalPlatform();
    const fast = {
      ...real,
      clock: {
        now: () => real.clock.now() * 20,
        after: (ms: number, call: () => void) => real.clock.after(ms / 20, call),
      },
    };
    const { proxy, script } = await behind("blocked", { platform: fast });
    expect(await script.right90()).toMatchObject({ state: "completed" });
    proxy.mode = "none";
    await expect.poll(() => proxy.upgrades, { timeout: 30_000 }).toBeGreaterThan(0);
    expect(await script.move(100)).toMatchObject({ state: "completed" });
  });
});
