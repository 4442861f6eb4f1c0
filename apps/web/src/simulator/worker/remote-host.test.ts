/**
 * The complete remote side of a page (host, link, loop, driver), against a relay that repeats
 * messages.
 */
import { describe, expect, it } from "vitest";
import { openRobot } from "./testing/remote-page.ts";

describe("a new key for scripts", () => {
  it("is used while the robot drives on", async () => {
    const { relay, host, view, states, drive, session } = await openRobot();
    relay.accept("A", 1);
    drive(50);
    const address = session.address.replace(/#.*/, "#drv_new");
    host.open({ ...session, driverKey: "drv_new", address }, false);
    expect(view().session).toMatchObject({ driverKey: "drv_new", address, lastApplied: 1 });
    drive(2_000);
    expect(states()).toEqual([[1, "completed", null]]);
    expect(relay.lines).toBe(1);
  });
});

describe("reconnecting after the connection was lost", () => {
  it("drives each command once and loses no ending", async () => {
    const { relay, host, view, states, drive, session } = await openRobot();
    for (const seq of [1, 2, 3]) relay.accept("A", seq);
    drive(100);
    relay.cut(1006);
    expect(view().status).toEqual({ kind: "lost", reason: "connectionLost" });
    drive(150);
    host.open({ ...session, lastApplied: 1 }, false);
    expect(relay.lines).toBe(2);
    expect(relay.pauses.size).toBe(0);
    relay.welcome("A");
    drive(5_000);
    expect(states()).toEqual([
      [3, "completed", null],
      [2, "completed", null],
      [1, "completed", null],
    ]);
    const received = (type: string) =>
      relay.received.flatMap((it) => (it["type"] === type ? it["seq"] : []));
    expect(relay.resume?.["endings"]).toMatchObject([{ seq: 1, state: "completed" }]);
    expect(received("started")).toEqual([1, 3]);
    expect(received("ended")).toEqual([2, 3]);
  });

  it("reports the connection that already exists", async () => {
    const { relay, host, view, session } = await openRobot();
    host.open(session, false);
    expect(relay.lines).toBe(1);
    expect(view().status).toEqual({ kind: "waiting" });
  });
});

describe("disconnecting while the connection is lost", () => {
  it("ends all commands, and the relay receives the endings when the page reconnects", async () => {
    const { relay, host, view, states, drive, session } = await openRobot();
    for (const seq of [1, 2]) relay.accept("A", seq);
    drive(100);
    relay.cut(1006);
    host.close();
    expect(view().status).toEqual({ kind: "off" });
    expect(states()).toEqual([
      [2, "cancelled", "disconnected"],
      [1, "cancelled", "disconnected"],
    ]);
    host.open(session, false);
    relay.welcome("A");
    const reason = "The robot's page disconnected.";
    expect(relay.resume).toMatchObject({
      lastApplied: 2,
      endings: [
        { seq: 1, state: "cancelled", reason },
        { seq: 2, state: "cancelled", reason },
      ],
    });
    relay.accept("A", 3);
    drive(1_000);
    expect(states()[0]).toEqual([3, "completed", null]);
  });
});

describe("another robot", () => {
  it.each([
    { code: 4410, reason: "over" },
    { code: 4404, reason: "noRobot" },
    { code: 4409, reason: "replaced" },
  ])("after $reason starts with nothing of the old one", async ({ code, reason }) => {
    const { relay, open, view, states, drive } = await openRobot();
    for (const seq of [1, 2]) relay.accept("A", seq);
    drive(100);
    relay.cut(code);
    expect(view().status).toEqual({ kind: "over", reason });
    expect(states()).toEqual([
      [2, "cancelled", "addressEnded"],
      [1, "cancelled", "addressEnded"],
    ]);
    await open(null);
    relay.welcome("B");
    expect(relay.resume).toMatchObject({ lastApplied: 0, endings: [] });
    expect(states()).toEqual([]);
    drive(1_000);
    relay.accept("B", 1);
    drive(1_000);
    expect(states()).toEqual([[1, "completed", null]]);
    expect(view().session).toMatchObject({ id: "B".repeat(22), lastApplied: 1 });
  });

  it("ends the commands of the one before it while that is still connected", async () => {
    const { relay, open, drive } = await openRobot();
    relay.accept("A", 1);
    drive(100);
    await open(null);
    expect(relay.received.at(-1)).toMatchObject({ type: "ended", seq: 1, state: "cancelled" });
    relay.welcome("B");
    expect(relay.resume).toMatchObject({ lastApplied: 0, endings: [] });
  });
});
