/** Guarded motions between a script and a host, with a real relay. */
import type { DeliveredCommand, RemoteCommand } from "@corridor/protocol";
import { describe, expect, it, onTestFinished } from "vitest";
import { HostConnection } from "../../../packages/client/src/host-connection.ts";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { RobotClient } from "../../../packages/client/src/robot-client.ts";
import { snapshotOf } from "../../../packages/protocol/src/testing/index.ts";
import { sharedRelayProcess } from "../../support/test-relay-process.ts";

const NEAR = { sensor: "front", is: "<=", than: 60 } as const;
const FORWARD = { action: "forward", until: [NEAR] };

const sharedRelay = sharedRelayProcess();

/** A host that starts each command, and ends it when the test says so. */
async function host() {
  const relay = await sharedRelay();
  const registration = await registerRobot(relay.url, fetch);
  const delivered: DeliveredCommand[] = [];
  const connection: HostConnection = new HostConnection({
    origin: relay.url,
    credentials: registration,
    lastApplied: 0,
    fresh: true,
    snapshot: () => snapshotOf(),
    onCommand: (command) => {
      delivered.push(command);
      connection.started(command.seq);
    },
    onStop: () => undefined,
    onCancel: () => undefined,
    onGiveBack: () => undefined,
    onYield: () => undefined,
    onState: () => undefined,
    onRefused: () => undefined,
    onStatus: ({ kind }) => {
      if (kind === "connected") connection.sendSnapshot(snapshotOf());
    },
    onDrivers: () => undefined,
  });
  onTestFinished(() => connection.close());
  const end = (seq: number): void => {
    const pose = { x: 150, y: 150, heading: 90 };
    connection.ended(seq, { state: "completed", reason: null, pose, distance: 90.5 });
  };
  const post = async (command: RemoteCommand | object, key = "key-0001") => {
    const url = `${relay.url}/api/v1/robots/${registration.id}/commands`;
    const headers = {
      Authorization: `Bearer ${registration.driverKey}`,
      "Content-Type": "application/json",
      "Idempotency-Key": key,
    };
    const response = await fetch(url, { method: "POST", headers, body: JSON.stringify(command) });
    return { status: response.status, body: await response.json() };
  };
  return { registration, delivered, end, post };
}

describe("a guarded motion at a real relay", () => {
  it("reaches the host with its conditions, and resolves at its end", async () => {
    const { registration, delivered, end } = await host();
    const script = await RobotClient.connect(registration.address);
    onTestFinished(() => script.close());
    let isOver = false;
    const motion = script.forward({ until: NEAR }).finally(() => (isOver = true));
    for await (const event of script.events()) {
      if (event.kind === "command" && event.command.state === "started") break;
    }
    expect(delivered).toMatchObject([{ command: FORWARD, lease: null }]);
    expect(isOver).toBe(false);
    end(1);
    expect(await motion).toMatchObject({ state: "completed", command: FORWARD, distance: 90.5 });
  });

  it("is one command with its conditions: others under the same key are a conflict", async () => {
    const { post } = await host();
    expect(await post(FORWARD)).toMatchObject({ status: 202, body: { command: FORWARD } });
    expect(await post(FORWARD)).toMatchObject({ status: 202, body: { duplicate: true } });
    const other = { ...FORWARD, until: [{ goal: true }] };
    for (const command of [other, { action: "forward" }]) {
      expect(await post(command)).toMatchObject({
        status: 409,
        body: { type: "/problems/key-conflict" },
      });
    }
  });

  it.each([
    { name: "another action", command: { action: "left 90", until: [NEAR] } },
    {
      name: "milliseconds",
      command: { action: "drive", left: 0, right: 0, milliseconds: 9, until: [NEAR] },
    },
    { name: "a lease", command: { action: "drive", left: 0, right: 0, lease: 500, until: [NEAR] } },
  ])("is refused with $name, and the response names the field", async ({ command }) => {
    const { post } = await host();
    const { status, body } = await post(command);
    expect([status, body.errors]).toMatchObject([400, [{ path: "until" }]]);
    expect(body.errors[0].expected).toMatch(/until .*(milliseconds)/);
  });
});
