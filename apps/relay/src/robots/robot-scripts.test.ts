import { describe, expect, it } from "vitest";
import { deafReader, withRobot, page, type Robot, type Host } from "./testing/robot-at-relay.ts";

describe("a robot session: the life of its scripts", () => {
  const name = (robot: Robot): string => robot.key.hash.slice(0, 6);
  const alive = (host: Host) =>
    host.told.flatMap((message) => (message.type === "drivers" ? [message.alive] : [])).at(-1);

  it("says within a second which script was heard, and for how long it has been silent", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    await robot.clock.pass(2_000);
    robot.session.heard(robot.key)();
    expect(alive(host)).toEqual([{ driver: name(robot), silentMs: 0, connectionMs: null }]);
    await robot.clock.pass(300);
    robot.session.heard(robot.key)();
    await robot.clock.pass(700);
    expect(alive(host)).toEqual([{ driver: name(robot), silentMs: 700, connectionMs: null }]);
  });

  it("takes a request that waits for a sign of life, each second, and none that was answered", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    const answered = robot.session.heard(robot.key);
    await robot.clock.pass(10_500);
    const before = host.told.length;
    await robot.clock.pass(2_000);
    expect(host.told.slice(before)).toHaveLength(2);
    expect(alive(host)).toMatchObject([{ silentMs: 0 }]);
    answered();
    await robot.clock.pass(2_000);
    const silent = host.told.length;
    await robot.clock.pass(10_000);
    expect(host.told).toHaveLength(silent);
  });

  it("hears a script that speaks on its line, and takes none of that for a request that waits", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    await robot.clock.pass(2_000);
    for (let n = 0; n < 3; n++) robot.session.spoke(robot.key);
    expect(alive(host)).toEqual([{ driver: name(robot), silentMs: 0, connectionMs: null }]);
    await robot.clock.pass(1_000);
    expect(alive(host)).toEqual([{ driver: name(robot), silentMs: 1_000, connectionMs: null }]);
    expect(robot.session.scripts).toMatchObject([{ silentMs: 1_000, connections: 0 }]);
    const told = host.told.length;
    await robot.clock.pass(5_000);
    expect(host.told).toHaveLength(told);
    robot.session.spoke(robot.key);
    expect(alive(host)).toMatchObject([{ silentMs: 0 }]);
    await robot.clock.pass(130_000);
    expect(robot.session.scripts).toEqual([]);
  });

  it("goes on to count a request as waiting while its script speaks on its line", async () => {
    const robot = await withRobot();
    await page(robot);
    const answered = robot.session.heard(robot.key);
    robot.session.spoke(robot.key);
    await robot.clock.pass(3_000);
    expect(robot.session.scripts).toMatchObject([{ silentMs: 0 }]);
    answered();
    await robot.clock.pass(3_000);
    expect(robot.session.scripts).toMatchObject([{ silentMs: 3_000 }]);
  });

  it("says at once that a script has a new line", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    robot.session.heard(robot.key)();
    robot.session.readers.join(
      robot.key,
      { snapshot: () => undefined, state: () => undefined, ...deafReader },
      null,
    );
    expect(alive(host)).toMatchObject([{ driver: name(robot), connectionMs: 0 }]);
  });
});
