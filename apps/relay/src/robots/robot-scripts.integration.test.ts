import { describe, expect, it } from "vitest";
import {
  ignoringReader,
  withRobot,
  page,
  type Setup,
  type Host,
} from "./testing/robot-at-relay.ts";

describe("a robot: activity of its scripts", () => {
  const name = (setup: Setup): string => setup.caller.hash.slice(0, 6);
  const alive = (host: Host) =>
    host.sent.flatMap((message) => (message.type === "drivers" ? [message.alive] : [])).at(-1);

  it("reports within a second which script was active, and for how long it has been silent", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    await setup.clock.pass(2_000);
    setup.robot.received(setup.caller)();
    expect(alive(host)).toEqual([{ driver: name(setup), silentMs: 0, connectionMs: null }]);
    await setup.clock.pass(300);
    setup.robot.received(setup.caller)();
    await setup.clock.pass(700);
    expect(alive(host)).toEqual([{ driver: name(setup), silentMs: 700, connectionMs: null }]);
  });

  it("counts a waiting request as activity each second, and an answered one no longer", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    const answered = setup.robot.received(setup.caller);
    await setup.clock.pass(10_500);
    const before = host.sent.length;
    await setup.clock.pass(2_000);
    expect(host.sent.slice(before)).toHaveLength(2);
    expect(alive(host)).toMatchObject([{ silentMs: 0 }]);
    answered();
    await setup.clock.pass(2_000);
    const silent = host.sent.length;
    await setup.clock.pass(10_000);
    expect(host.sent).toHaveLength(silent);
  });

  it("counts messages on a connection as activity, but not as waiting requests", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    await setup.clock.pass(2_000);
    for (let n = 0; n < 3; n++) setup.robot.spoke(setup.caller);
    expect(alive(host)).toEqual([{ driver: name(setup), silentMs: 0, connectionMs: null }]);
    await setup.clock.pass(1_000);
    expect(alive(host)).toEqual([{ driver: name(setup), silentMs: 1_000, connectionMs: null }]);
    expect(setup.robot.scripts).toMatchObject([{ silentMs: 1_000, connections: 0 }]);
    const sent = host.sent.length;
    await setup.clock.pass(5_000);
    expect(host.sent).toHaveLength(sent);
    setup.robot.spoke(setup.caller);
    expect(alive(host)).toMatchObject([{ silentMs: 0 }]);
    await setup.clock.pass(130_000);
    expect(setup.robot.scripts).toEqual([]);
  });

  it("counts a request as waiting while its script sends messages on its connection", async () => {
    const setup = await withRobot();
    await page(setup);
    const answered = setup.robot.received(setup.caller);
    setup.robot.spoke(setup.caller);
    await setup.clock.pass(3_000);
    expect(setup.robot.scripts).toMatchObject([{ silentMs: 0 }]);
    answered();
    await setup.clock.pass(3_000);
    expect(setup.robot.scripts).toMatchObject([{ silentMs: 3_000 }]);
  });

  it("reports a new connection of a script immediately", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    setup.robot.received(setup.caller)();
    setup.robot.readers.join(
      setup.caller,
      { snapshot: () => undefined, state: () => undefined, ...ignoringReader },
      null,
    );
    expect(alive(host)).toMatchObject([{ driver: name(setup), connectionMs: 0 }]);
  });
});
