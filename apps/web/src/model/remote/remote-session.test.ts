import type { DriverName } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { createRemoteStore } from "./remote-store.ts";
import { createRunStore } from "../run/run-store.ts";
import type { RemoteSession, ToWorker } from "../../simulator/protocol/worker-messages.ts";
import { readSession, RemoteConnection } from "./remote-session.ts";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";

const session: RemoteSession = {
  id: "r1",
  ownerKey: "owner",
  driverKey: "driver",
  address: "https://host/r/r1#driver",
  lastApplied: 0,
};

function openPage(tab = new MemoryStorage()) {
  const sent: ToWorker[] = [];
  const run = createRunStore();
  const remote = createRemoteStore();
  const simulator = { send: (message: ToWorker) => void sent.push(message) };
  const connection = new RemoteConnection({ simulator, remote, run, tab });
  const drive = (driver: DriverName) => run.setState({ nowDriver: driver });
  return { sent, run, remote, connection, tab, drive };
}

describe("RemoteConnection", () => {
  it("requests a new robot when remote drives for the first time, and not again", () => {
    const page = openPage();
    page.drive("program");
    expect(page.sent).toEqual([]);
    page.drive("remote");
    page.remote.setState({ status: { kind: "connecting" } });
    page.drive("remote");
    page.drive("me");
    page.drive("remote");
    expect(page.sent).toEqual([{ type: "remote-open", session: null, fresh: true }]);
  });

  it("lets Remote drive when the user connects while another driver has the robot", () => {
    const page = openPage();
    page.drive("program");
    page.connection.connect();
    page.drive("remote");
    expect(page.sent).toEqual([
      { type: "remote-open", session: null, fresh: true },
      { type: "driver", driver: "remote" },
    ]);
  });

  it("gets an address while another driver has the robot, which the next reload does not resume", () => {
    const page = openPage();
    page.drive("program");
    page.connection.open();
    page.remote.setState({ status: { kind: "waiting" }, session });
    expect(page.sent).toEqual([{ type: "remote-open", session: null, fresh: true }]);
    const reloaded = openPage(page.tab);
    reloaded.connection.resume();
    expect(reloaded.sent).toEqual([]);
    reloaded.drive("remote");
    expect(reloaded.sent).toEqual([{ type: "remote-open", session, fresh: true }]);
  });

  it("stays off after the user disconnected, until remote is chosen again", () => {
    const page = openPage();
    page.drive("remote");
    page.remote.setState({ status: { kind: "waiting" }, session });
    page.connection.disconnect();
    page.remote.setState({ status: { kind: "off" } });
    page.drive("remote");
    expect(page.sent.map(({ type }) => type)).toEqual(["remote-open", "remote-close"]);
    page.drive("me");
    page.drive("remote");
    expect(page.sent.at(-1)).toEqual({ type: "remote-open", session, fresh: false });
  });

  it.each([
    { name: "connects again while Remote drives", driver: "remote", opened: 2 },
    { name: "leaves it while somebody else drives", driver: "me", opened: 1 },
  ] as const)("$name when a network that was lost is back", ({ driver, opened }) => {
    const page = openPage();
    page.drive("remote");
    page.remote.setState({ status: { kind: "lost", reason: "connectionLost" } });
    page.drive(driver);
    page.connection.reconnect();
    expect(page.sent.filter(({ type }) => type === "remote-open")).toHaveLength(opened);
  });

  it("does not reconnect what is connected when the network returns", () => {
    const page = openPage();
    page.drive("remote");
    page.remote.setState({ status: { kind: "waiting" }, session });
    page.connection.reconnect();
    expect(page.sent).toHaveLength(1);
  });

  it("retains the robot's address over a reload, with the newest command that was started", () => {
    const page = openPage();
    page.remote.setState({ status: { kind: "waiting" }, session });
    page.remote.setState({ session: { ...session, lastApplied: 7 } });
    const reloaded = openPage(page.tab);
    expect(reloaded.sent).toEqual([]);
    reloaded.drive("remote");
    expect(reloaded.sent).toEqual([
      { type: "remote-open", session: { ...session, lastApplied: 7 }, fresh: true },
    ]);
  });

  it("resumes by itself after a reload during remote driving", () => {
    const page = openPage();
    page.drive("remote");
    page.remote.setState({ status: { kind: "waiting" }, session });
    // Twice, and the second page's worker starts with its own driver.
    for (let reload = 0; reload < 2; reload++) {
      const reloaded = openPage(page.tab);
      reloaded.drive("program");
      expect(reloaded.sent).toEqual([]);
      reloaded.connection.resume();
      reloaded.drive("remote");
      expect(reloaded.sent).toEqual([
        { type: "remote-open", session, fresh: true },
        { type: "driver", driver: "remote" },
      ]);
    }
  });

  it("resumes after a reload also if it was disconnected and connected again before", () => {
    const page = openPage();
    page.drive("remote");
    page.remote.setState({ status: { kind: "waiting" }, session });
    page.connection.disconnect();
    page.remote.setState({ status: { kind: "off" } });
    page.connection.connect();
    const reloaded = openPage(page.tab);
    reloaded.connection.resume();
    expect(reloaded.sent).toContainEqual({ type: "driver", driver: "remote" });
  });

  it("leaves the robot to the user who took it while the previous run was restored", () => {
    const page = openPage();
    page.drive("remote");
    page.remote.setState({ status: { kind: "waiting" }, session });
    const reloaded = openPage(page.tab);
    reloaded.drive("me");
    reloaded.connection.resume();
    expect(reloaded.sent).toEqual([]);
  });

  it.each(["me", "program"] as const)("leaves a reload alone when %s drove last", (driver) => {
    const page = openPage();
    page.drive("remote");
    page.remote.setState({ status: { kind: "waiting" }, session });
    page.drive(driver);
    const reloaded = openPage(page.tab);
    reloaded.connection.resume();
    expect(reloaded.sent).toEqual([]);
  });

  it("requests another robot once the session is over", () => {
    const page = openPage();
    page.remote.setState({ status: { kind: "waiting" }, session });
    page.remote.setState({ status: { kind: "over", reason: "over" } });
    page.drive("remote");
    page.connection.connect();
    expect(page.sent).toEqual([{ type: "remote-open", session: null, fresh: true }]);
  });

  it("works without a stored address if the storage is full", () => {
    const tab = new MemoryStorage();
    tab.isFull = true;
    const page = openPage(tab);
    page.remote.setState({ status: { kind: "waiting" }, session });
    expect(readSession(tab)).toBeNull();
  });
});

describe("readSession", () => {
  it.each([
    { name: "nonsense", text: "{" },
    { name: "null", text: "null" },
    { name: "a key that is no text", text: JSON.stringify({ ...session, ownerKey: 1 }) },
    { name: "an empty id", text: JSON.stringify({ ...session, id: "" }) },
    { name: "a huge address", text: JSON.stringify({ ...session, address: "x".repeat(9_999) }) },
    { name: "a negative count", text: JSON.stringify({ ...session, lastApplied: -1 }) },
    { name: "a count that is no number", text: JSON.stringify({ ...session, lastApplied: null }) },
  ])("treats $name as no session", ({ text }) => {
    const tab = new MemoryStorage();
    tab.setItem("corridor.remote", text);
    expect(readSession(tab)).toBeNull();
  });
});
