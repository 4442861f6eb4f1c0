import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { settled } from "../platform/testing/fake-clock.ts";
import { completed } from "../platform/testing/messages.ts";
import { limits } from "../platform/limits/limits.ts";
import { ignoringReader, LEFT, waitLimit, withRobot, page } from "./testing/robot-at-relay.ts";

describe("a robot: snapshots and states for scripts", () => {
  it("sends a reader the newest snapshot at most 20 times a second", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    const seen: number[] = [];
    setup.robot.readers.join(
      setup.caller,
      { snapshot: ({ seq }) => seen.push(seq), state: () => undefined, ...ignoringReader },
      null,
    );
    for (let seq = 1; seq <= 100; seq++) {
      await host.report({ seq });
      await setup.clock.pass(10);
    }
    await setup.clock.pass(100);
    expect(seen.length).toBeGreaterThan(15);
    expect(seen.length).toBeLessThanOrEqual(22);
    expect(seen.at(-1)).toBe(100);
  });

  it("sends a slow reader no outdated snapshots, and drops one that does not read", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    const flow = { sentBytes: 0, takenBytes: 0, isProof: false, ask: () => undefined };
    const seen: number[] = [];
    const over: string[] = [];
    const snapshot = ({ seq }: { seq: number }): void => {
      seen.push(seq);
      flow.sentBytes += 400;
    };
    setup.robot.readers.join(
      setup.caller,
      {
        ...ignoringReader,
        snapshot,
        state: () => undefined,
        over: (reason) => over.push(reason),
        transport: "events",
        flow,
      },
      null,
    );
    for (let seq = 1; seq <= 9; seq++) {
      await host.report({ seq });
      await setup.clock.pass(limits.snapshotIntervalMs);
    }
    expect(seen).toEqual([1, 2]);
    flow.takenBytes = flow.sentBytes;
    await setup.clock.pass(limits.snapshotIntervalMs);
    expect(seen).toEqual([1, 2, 9]);
    flow.sentBytes += limits.stuckReaderBytes + 1;
    await setup.submit(LEFT);
    expect(over).toEqual(["tooSlow"]);
  });

  it("sends a newer snapshot before the ending that followed it", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    await setup.submit(LEFT);
    const said: string[] = [];
    setup.robot.readers.join(
      setup.caller,
      {
        snapshot: ({ seq }) => said.push(`snapshot ${seq}`),
        state: ({ record }) => said.push(record.state),
        ...ignoringReader,
      },
      null,
    );
    await host.report({ seq: 1 });
    await host.report({ seq: 2 });
    await host.ended(completed(1));
    expect(said).toEqual(["snapshot 1", "snapshot 2", "completed"]);
  });

  it("sends the current snapshot before the endings that a page reports when it connects", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    await setup.submit(LEFT);
    await host.started(1);
    await host.report({ seq: 1, tick: 100 });
    setup.robot.page.leave(host.connection, true);
    const ended = setup.robot.endOf(1, waitLimit(20_000));
    const read = ended.then(({ state }) => `${state} at ${setup.robot.newest?.tick}`);
    const snapshot = snapshotOf({ seq: 2, tick: 200 });
    await page(setup, { lastApplied: 1, endings: [completed(1)], snapshot });
    expect(await read).toBe("completed at 200");
  });

  it("distinguishes a running, a paused and a disconnected robot", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    await host.report({ tick: 1 });
    expect(setup.robot.newest?.state).toBe("running");
    await setup.clock.pass(5_000);
    expect(setup.robot.newest?.state).toBe("paused");
    setup.robot.page.leave(host.connection, true);
    expect(setup.robot.newest?.state).toBe("gone");
  });

  it("reports a robot whose ticks do not advance as paused until they advance", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let second = 0; second < 5; second++) {
      await host.report({ seq: second, tick: 7 });
      await setup.clock.pass(1_000);
    }
    expect(setup.robot.newest?.state).toBe("paused");
    await host.report({ seq: 9, tick: 8 });
    expect(setup.robot.newest?.state).toBe("running");
  });

  it("continues the numbers of snapshots when a reloaded page restarts at 1", async () => {
    const setup = await withRobot();
    await (await page(setup)).report({ seq: 900 });
    await (await page(setup)).report({ seq: 1 });
    expect(setup.robot.newest?.seq).toBe(901);
  });

  it("answers a long poll when an event occurs, or after the wait if none occurs", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    await host.report({ seq: 7 });
    const newer = setup.robot.readers.nextSnapshot(7, waitLimit(25_000));
    await host.report({ seq: 8 });
    expect(await newer).toMatchObject({ seq: 8 });
    const none = setup.robot.readers.nextSnapshot(8, waitLimit(25_000));
    await setup.clock.pass(3_000);
    await host.report({ seq: 8 });
    expect(await none).toMatchObject({ seq: 9 });
    const gone = setup.robot.readers.nextSnapshot(9, waitLimit(25_000));
    setup.robot.page.leave(host.connection, true);
    expect(await gone).toMatchObject({ seq: 9, state: "gone" });
    const quiet = setup.robot.readers.nextSnapshot(9, waitLimit(25_000));
    await setup.clock.pass(25_000);
    expect(await quiet).toMatchObject({ seq: 9, state: "gone" });
  });

  it("waits for the end of a command", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    await setup.submit(LEFT);
    const end = setup.robot.endOf(1, waitLimit(25_000));
    await settled();
    await host.ended(completed(1));
    expect(await end).toMatchObject({ state: "completed" });
    expect(await setup.robot.endOf(1, waitLimit(25_000))).toMatchObject({ state: "completed" });
    await expect(setup.robot.endOf(2, waitLimit(0))).rejects.toMatchObject({
      kind: "no-command",
    });
  });

  it("explains what to check if a command does not end because the page is disconnected or paused", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    for (let n = 0; n < 2; n++) await setup.submit(LEFT);
    await host.started(1);
    const end = async (seq: number, ms = 5_000) => {
      const waits = setup.robot.endOf(seq, waitLimit(ms));
      await settled();
      await setup.clock.pass(ms);
      return waits;
    };
    await host.report({ tick: 1 });
    expect(await end(1, 100)).toMatchObject({ state: "started", reason: null });
    await host.report({ tick: 2, state: "paused" });
    expect((await end(1, 100)).reason).toBe("The run is paused: press Run on the robot's page.");
    const advice = /check that the robot's page is open, connected under Remote and not paused/;
    expect((await end(1, limits.asleepMs + 5_000)).reason).toMatch(advice);
    setup.robot.page.leave(host.connection, true);
    const closed =
      /page is closed or offline: open it again and choose Remote\. If it says Off, press Connect\. If you closed its tab, copy/;
    for (const seq of [1, 2]) expect((await end(seq)).reason).toMatch(closed);
    // The advice is not stored.
    expect(await setup.robot.endOf(1, waitLimit(0))).toMatchObject({ reason: null });
  });

  it("reports its scripts to the page, at most once a second", async () => {
    const setup = await withRobot();
    const host = await page(setup);
    await setup.clock.pass(2_000);
    const before = host.sent.length;
    for (let n = 0; n < 50; n++) {
      setup.robot.received(setup.caller)();
      await setup.clock.pass(100);
    }
    const drivers = host.sent.slice(before).filter(({ type }) => type === "drivers");
    expect(drivers.length).toBeGreaterThanOrEqual(5);
    expect(drivers.length).toBeLessThanOrEqual(6);
    expect(drivers.at(-1)).toMatchObject({ connected: 0, client: "Python" });
  });
});
