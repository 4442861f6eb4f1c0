import { describe, expect, it } from "vitest";
import { openPage } from "./testing/remote-page.ts";

describe("a robot that is not registered", () => {
  it.each([
    { name: "nothing answers", isReachable: false, status: 0, reason: "connectionLost" },
    { name: "only files are served", isReachable: true, status: 405, reason: "noService" },
    { name: "too many were registered", isReachable: true, status: 429, reason: "tooManyRobots" },
    { name: "the service is in trouble", isReachable: true, status: 503, reason: "refused" },
  ])("shows the cause when $name", async ({ isReachable, status, reason }) => {
    const { relay, open, view } = openPage();
    Object.assign(relay, { isReachable, status });
    await open(null);
    expect(view()).toMatchObject({ status: { kind: "lost", reason }, session: null });
  });

  it("is registered without user action once the network is back", async () => {
    const { relay, open, view } = openPage();
    relay.isReachable = false;
    await open(null);
    relay.isReachable = true;
    relay.pauseOver();
    await expect.poll(() => relay.lines).toBe(1);
    relay.welcome("A");
    expect(view()).toMatchObject({ status: { kind: "waiting" }, session: { id: "A".repeat(22) } });
  });

  it("is not registered later if the user disconnected, and once if they reconnected", async () => {
    const { relay, host, open, view } = openPage();
    relay.isReachable = false;
    await open(null);
    const pauseOver = [...relay.pauses];
    host.close();
    relay.isReachable = true;
    for (const over of pauseOver) over();
    await open(null);
    relay.welcome("A");
    expect(relay.registered).toBe(1);
    expect(view().status).toEqual({ kind: "waiting" });
  });
});
