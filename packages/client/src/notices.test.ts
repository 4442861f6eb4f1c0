import { snapshotOf } from "@corridor/protocol/testing";
import type { Snapshot } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { RobotClient } from "./robot-client.ts";
import { FakePlatform } from "./testing/fake-platform.ts";
import { ADDRESS, record } from "./testing/messages.ts";

const CLOSED = expect.stringMatching(/^The robot's page is closed or offline: open it again/);
const PAUSED = "The run is paused: press Run on the robot's page.";
const ASLEEP = expect.stringMatching(/^The robot does not answer: check that the robot's page/);

function welcome(platform: FakePlatform): void {
  platform.socket.open();
  platform.socket.receive({
    type: "welcome",
    version: 1,
    stream: "k3J9x2aB",
    n: 0,
    snapshot: snapshotOf({ seq: 1 }),
  });
}

/** A script that waits for the end of a move which has started. */
async function moving() {
  const platform = new FakePlatform();
  const opening = RobotClient.connect(ADDRESS, { platform });
  welcome(platform);
  const robot = await opening;
  const move = robot.move(300);
  const report = (state: "started" | "completed"): void => {
    const key = String(platform.socket.sent.find(({ type }) => type === "command")?.["key"]);
    const done = record(1, key, { action: "move", distance: 300 }, { state });
    platform.socket.receive({ type: "ack", record: done });
    platform.socket.receive({ type: "state", n: 1, record: done });
  };
  report("started");
  const see = (seq: number, state: Snapshot["state"]): void =>
    platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq, state }) });
  return { platform, robot, move, report, see };
}

/** Passes time in which the relay only sends heartbeats. */
function pass(platform: FakePlatform, seconds: number): void {
  for (let second = 0; second < seconds; second++) {
    platform.pass(1_000);
    platform.socket.receive({ type: "heartbeat" });
  }
}

describe("a script that waits for the end of a command", () => {
  it.each([
    { name: "closed", seq: 1, state: "gone", reason: CLOSED },
    { name: "paused", seq: 2, state: "paused", reason: PAUSED },
    { name: "asleep", seq: 1, state: "paused", reason: ASLEEP },
  ] as const)("prints once, after 3 s, that the page is $name", async (page) => {
    const { platform, move, report, see } = await moving();
    see(page.seq, page.state);
    pass(platform, 2);
    expect(platform.warnings).toEqual([]);
    pass(platform, 60);
    expect(platform.warnings).toEqual([page.reason]);
    report("completed");
    await move;
  });

  it("prints it again only after the robot has continued", async () => {
    const { platform, see } = await moving();
    see(2, "paused");
    pass(platform, 10);
    see(3, "running");
    pass(platform, 10);
    expect(platform.warnings).toEqual([PAUSED]);
    see(4, "paused");
    pass(platform, 10);
    expect(platform.warnings).toEqual([PAUSED, PAUSED]);
  });

  it("prints nothing while the robot moves, after a short pause or after the end", async () => {
    const { platform, move, report, see } = await moving();
    pass(platform, 10);
    see(2, "paused");
    pass(platform, 2);
    see(3, "running");
    pass(platform, 10);
    report("completed");
    await move;
    see(4, "gone");
    pass(platform, 10);
    expect(platform.warnings).toEqual([]);
  });
});

it("a script that reads a closed page prints once that it waits", async () => {
  const { platform, robot, see } = await moving();
  await robot.snapshot();
  const reading = robot.sensors();
  see(1, "gone");
  see(1, "gone");
  expect(platform.warnings).toEqual([
    "The robot's page is closed or not connected. Open the page again and choose Remote. " +
      "If it says Off, press Connect. If you closed its tab, copy the new address into the script. " +
      "Waiting for the page.",
  ]);
  see(2, "running");
  await reading;
});

describe("a script whose service is not reachable", () => {
  const line = "The robot's host does not respond at http://localhost:8080. Retrying.";

  it("prints so once, at once, if the service refuses the connection", async () => {
    const platform = new FakePlatform();
    const opening = RobotClient.connect(ADDRESS, { platform });
    platform.socket.cut(1006);
    expect(platform.warnings).toEqual([line]);
    for (let attempt = 0; attempt < 5; attempt++) {
      platform.pass(500);
      platform.socket.cut(1006);
    }
    expect(platform.warnings).toEqual([line]);
    platform.pass(5_000);
    welcome(platform);
    (await opening).close();
  });

  it("prints so after 5 s if nothing responds", async () => {
    const platform = new FakePlatform();
    const opening = RobotClient.connect(ADDRESS, { platform });
    platform.pass(4_000);
    expect(platform.warnings).toEqual([]);
    platform.pass(26_000);
    expect(platform.warnings).toEqual([line]);
    await expect(opening).rejects.toMatchObject({
      message:
        "The robot's host does not respond (timeout). " +
        "Check the network, and that the robot is at http://localhost:8080.",
    });
  });

  it("prints nothing about a connection that returns at once", async () => {
    const { platform } = await moving();
    platform.socket.cut(1006);
    platform.pass(1_000);
    welcome(platform);
    pass(platform, 60);
    expect(platform.warnings).toEqual([]);
  });
});
