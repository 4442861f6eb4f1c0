/** How many snapshots a reader receives from the real relay, and how many it acknowledges. */
import { describe, expect, it, onTestFinished } from "vitest";
import { connectionUrls } from "../../../packages/client/src/connection-urls.ts";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { parseRobotAddress } from "../../../packages/client/src/robot-address.ts";
import { RobotClient } from "../../../packages/client/src/robot-client.ts";
import { GridRobot } from "../../support/client/grid-robot.ts";
import { slowNetwork, type SlowNetwork } from "../../support/client/slow-network.ts";
import { sharedRelayProcess } from "../../support/test-relay-process.ts";

/** Waits until the network has received this many more snapshots. */
async function receive(network: SlowNetwork, snapshots: number): Promise<void> {
  const until = counts(network).snapshots + snapshots;
  await expect
    .poll(() => counts(network).snapshots, { timeout: 30_000, interval: 20 })
    .toBeGreaterThanOrEqual(until);
}

const sharedRelay = sharedRelayProcess();

/** The address of a robot whose page reports more often than the relay sends snapshots. */
async function reportingRobot(): Promise<string> {
  const relay = await sharedRelay();
  const registration = await registerRobot(relay.url, fetch);
  const robot = new GridRobot(relay.url, registration, ["###", "#.#", "###"]);
  const timer = setInterval(() => robot.connection.sendSnapshot(robot.snapshot()), 1_000 / 30);
  onTestFinished(() => {
    clearInterval(timer);
    robot.connection.close();
  });
  return registration.address;
}

async function readAsClient(address: string, network: SlowNetwork): Promise<void> {
  const reader = await RobotClient.connect(address, { platform: network.platform });
  onTestFinished(() => reader.close());
}

/** Acknowledges each snapshot, as simple scripts do. */
function readAcknowledgingEach(address: string, network: SlowNetwork): void {
  const { origin, id, key } = parseRobotAddress(address);
  const socket = network.platform.connect(connectionUrls(origin, "robots", id).websocket, {
    opened: () => socket.send(JSON.stringify({ type: "hello", version: 1, role: "drive", key })),
    received: (text) => {
      const message = JSON.parse(text) as { type: string; snapshot: { seq: number } };
      if (message.type !== "snapshot") return;
      socket.send(JSON.stringify({ type: "seen", seq: message.snapshot.seq }));
    },
    closed: () => undefined,
  });
  onTestFinished(() => socket.close(1000, ""));
}

/** Two readers of one robot over networks of the same latency; the second is the client. */
async function twoReaders(delayMs: number): Promise<readonly [SlowNetwork, SlowNetwork]> {
  const address = await reportingRobot();
  const networks = [slowNetwork(delayMs), slowNetwork(delayMs)] as const;
  readAcknowledgingEach(address, networks[0]);
  await readAsClient(address, networks[1]);
  // The client adapts after the first late snapshots.
  await receive(networks[0], 20);
  return networks;
}

/** What both receive while the first one receives 60 snapshots. */
async function compare(networks: readonly [SlowNetwork, SlowNetwork]) {
  const before = [counts(networks[0]), counts(networks[1])] as const;
  await receive(networks[0], 60);
  return {
    each: since(before[0], counts(networks[0])),
    client: since(before[1], counts(networks[1])),
  };
}

interface Counts {
  snapshots: number;
  seen: number;
}

function counts({ received, sent }: SlowNetwork): Counts {
  return { snapshots: received.get("snapshot") ?? 0, seen: sent.get("seen") ?? 0 };
}

function since(before: Counts, now: Counts): Counts {
  return { snapshots: now.snapshots - before.snapshots, seen: now.seen - before.seen };
}

function acknowledgedShare({ client }: { client: Counts }): number {
  return client.seen / client.snapshots;
}

describe("a reader of the real relay", () => {
  it("receives 20 snapshots a second, and acknowledges half of them once none is late", async () => {
    const networks = await twoReaders(0);
    const counted = await compare(networks);
    expect(counted.client.snapshots).toBeGreaterThan(0.9 * counted.each.snapshots);
    // On a busy machine some snapshots are late, and the client acknowledges each for seconds
    // after.
    await expect
      .poll(async () => acknowledgedShare(await compare(networks)), {
        timeout: 50_000,
        interval: 0,
      })
      .toBeLessThan(0.65);
  }, 60_000);

  it.each([38, 40, 100])(
    "receives as many over a network with a latency of %i ms",
    async (delayMs) => {
      const { each, client } = await compare(await twoReaders(delayMs));
      expect(client.snapshots).toBeGreaterThan(0.9 * each.snapshots);
    },
  );
});
