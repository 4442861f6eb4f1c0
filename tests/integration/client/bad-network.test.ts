/** An example in Java drives a robot over a network that delays, slices and cuts connections. */
import { expect, it, onTestFinished } from "vitest";
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { FaultProxy } from "../../../e2e/faults/net/fault-proxy.ts";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { inPath } from "../../../scripts/programs.ts";
import { startSimulatedPage } from "../../support/client/simulated-page.ts";
import { followedMaze, followWall } from "../../support/client/wall-follower.ts";
import { startRelayProcess } from "../../support/test-relay-process.ts";

it(
  "the Java follower drives every step correctly while the network cuts, delays and slices",
  { timeout: 300_000 },
  async ({ skip }) => {
    const isMissing = inPath("java").length === 0;
    if (isMissing) process.stderr.write("bad-network.test.ts: skipped, java is not installed\n");
    skip(isMissing);
    const { url, port } = await startRelayProcess();
    const network = await FaultProxy.start({ target: () => port, random: new SeededRandom(1) });
    onTestFinished(() => network.close());
    const follow = async (isBad: boolean) => {
      const registration = await registerRobot(url, fetch);
      // The page also connects through the network.
      const { robot, page } = startSimulatedPage(network.origin, registration, followedMaze);
      page.setSpeed(16);
      await expect.poll(() => robot.isConnected, { timeout: 30_000 }).toBe(true);
      const address = `${network.origin}/r/${registration.id}#${registration.driverKey}`;
      const followed = await followWall("Java", address, { network, isBad });
      page.close();
      return followed;
    };
    const baseline = await follow(false);
    expect(baseline).toMatchObject({ code: 0, bumps: 0, hasVisitedAll: true, cut: 0 });
    const bad = await follow(true);
    expect(bad.cut).toBeGreaterThan(20);
    expect(bad).toEqual({ ...baseline, cut: bad.cut });
  },
);
