import { describe, expect, it } from "vitest";
import type { Refusal } from "../platform/errors/problems.ts";
import { completed } from "../platform/testing/messages.ts";
import { LEFT, withRobot, page, type Setup, type Host } from "./testing/robot-at-relay.ts";

describe("a robot: limits", () => {
  it("accepts a burst of 40 commands, 20 a second, and always a stop", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    const send = async (): Promise<string> => {
      try {
        const record = await setup.submit(LEFT);
        await host.ended(completed(record?.seq ?? 0));
        return "stored";
      } catch (error) {
        return (error as Refusal).kind;
      }
    };
    const outcomes: string[] = [];
    for (let n = 0; n < 45; n++) outcomes.push(await send());
    expect(outcomes.filter((outcome) => outcome === "stored")).toHaveLength(40);
    expect(outcomes.at(-1)).toBe("too-fast");
    expect(await setup.submit({ action: "stop" })).toMatchObject({ state: "accepted" });
    await setup.clock.pass(50);
    expect([await send(), await send()]).toEqual(["stored", "too-fast"]);
  });

  it("stores a burst of 20 stops and 5 a second; further stops return the open one", async () => {
    const setup = await withRobot();
    await page(setup);
    for (let n = 1; n <= 20; n++) {
      expect(await setup.submit({ action: "stop" })).toMatchObject({ seq: n, duplicate: false });
    }
    expect(await setup.submit({ action: "stop" })).toMatchObject({ seq: 20, duplicate: true });
    const keyed = setup.submit({ action: "stop" }, "key-0001");
    await expect(keyed).rejects.toMatchObject({ kind: "too-fast" });
    await setup.clock.pass(200);
    expect(await setup.submit({ action: "stop" }, "key-0001")).toMatchObject({ seq: 21 });
    expect(await setup.submit({ action: "stop" }, "key-0001")).toMatchObject({ seq: 21 });
  });

  it.each([
    { name: "has ended", meanwhile: (host: Host) => host.ended(completed(20)) },
    { name: "is followed by a command", meanwhile: (_: Host, setup: Setup) => setup.submit(LEFT) },
  ])("rejects a stop above the limit if the previous one $name", async ({ meanwhile }) => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let n = 0; n < 20; n++) await setup.submit({ action: "stop" });
    await meanwhile(host, setup);
    await expect(setup.submit({ action: "stop" })).rejects.toMatchObject({ kind: "too-fast" });
    await setup.clock.pass(200);
    expect(await setup.submit({ action: "stop" })).toMatchObject({ duplicate: false });
  });

  it("queues 64 commands and rejects the 65th", async () => {
    const setup = await withRobot();
    for (let n = 0; n < 64; n++) {
      await setup.submit(LEFT);
      await setup.clock.pass(50);
    }
    const refused = setup.submit(LEFT, "key-0001");
    await expect(refused).rejects.toMatchObject({
      kind: "queue-full",
      headers: { "Retry-After": "1" },
    });
  });

  it("lets a class register at the same time, but limits a flood", async () => {
    const { registry } = await withRobot();
    const register = () => registry.register("10.0.0.2", "http://localhost");
    for (let n = 0; n < 200; n++) await register();
    await expect(register()).rejects.toMatchObject({ kind: "too-fast" });
    await expect(registry.register("10.0.0.3", "http://localhost")).resolves.toBeDefined();
  });
});
