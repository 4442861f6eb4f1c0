import { closeReasons } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { LEFT, withRobot, page } from "./testing/robot-at-relay.ts";

describe("a robot: its end", () => {
  it("is deleted two hours after its last use, and everyone is disconnected", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    await setup.clock.pass(60 * 60 * 1000);
    await host.report();
    await setup.clock.pass(90 * 60 * 1000);
    expect(host.closed).toEqual([]);
    await setup.clock.pass(35 * 60 * 1000);
    expect(host.closed).toEqual([closeReasons.over.code]);
    const { registry, registration } = setup;
    await expect(
      registry.authorise(registration.id, registration.driverKey, "command"),
    ).rejects.toMatchObject({ kind: "no-robot" });
  });

  it("is deleted after a day, however busy it is", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let hour = 0; hour < 24; hour++) {
      await host.report();
      await setup.clock.pass(60 * 60 * 1000);
    }
    await setup.clock.pass(2 * 60 * 1000);
    expect(host.closed).toEqual([closeReasons.over.code]);
  });
});

describe("a relay that shuts down", () => {
  it("asks clients to retry, and never reports a robot or a key as unknown", async () => {
    const { registry, registration, submit } = await withRobot();
    await registry.close();
    const restarting = expect.objectContaining({ kind: "restarting" });
    await expect(submit(LEFT)).rejects.toEqual(restarting);
    await expect(
      registry.authorise(registration.id, registration.driverKey, "command"),
    ).rejects.toEqual(restarting);
    await expect(registry.register("10.0.0.1", "http://localhost")).rejects.toEqual(restarting);
  });
});
