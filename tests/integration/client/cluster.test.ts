/** Page and script at a cluster of relays, while relays are killed. */
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { findRedis } from "../../../scripts/redis-server.ts";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { RobotClient } from "../../../packages/client/src/robot-client.ts";
import { startCluster } from "../../support/client/cluster.ts";
import { GridRobot } from "../../support/client/grid-robot.ts";

const CORRIDOR = ["#".repeat(62), `#${".".repeat(60)}#`, "#".repeat(62)];
/** for the robot to reconnect after its relay was killed */
const RECONNECT = { timeout: 5_000, interval: 20 };

describe.skipIf(findRedis() === null)("a cluster of relays", () => {
  it("neither loses, duplicates nor reorders commands while relays are killed", async () => {
    const cluster = await startCluster();
    const [first, second] = [await cluster.startRelay(), await cluster.startRelay()];
    cluster.sendTo(first);
    const registration = await registerRobot(cluster.origin, fetch);
    const robot = new GridRobot(cluster.origin, registration, CORRIDOR);
    onTestFinished(() => robot.connection.close());
    const connections = (): number => robot.statuses.filter((kind) => kind === "connected").length;
    const isReconnected = async (times: number): Promise<void> =>
      vi.waitFor(() => expect(connections()).toBe(times), RECONNECT);
    await isReconnected(1);
    cluster.sendTo(second);
    const script = await RobotClient.connect(registration.address, { ttl: 60_000 });
    onTestFinished(() => script.close());
    await script.right90();
    expect((await script.sensors()).front).toBe(5_950);

    const records: Promise<{ seq: number; state: string }>[] = [];
    for (let n = 0; n < 50; n++) records.push(script.move(100));
    await records[9];
    cluster.sendTo(first, second);
    await first.kill();
    await isReconnected(2);
    await records[29];
    const third = await cluster.startRelay();
    cluster.sendTo(second, third);
    await second.kill();
    await isReconnected(3);

    const all = await Promise.all(records);
    expect(all.map(({ state }) => state)).toEqual(all.map(() => "completed"));
    expect(all.map(({ seq }) => seq)).toEqual(all.map((_record, index) => index + 2));
    expect(robot.done).toHaveLength(51);
    expect(robot.snapshot().pose.x).toBe(5_150);
    expect((await script.sensors()).front).toBe(950);
  });
});
