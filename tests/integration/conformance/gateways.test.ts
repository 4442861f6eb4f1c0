/**
 * The gateways of a relay pass the checks of `corridor conformance --gateways`, with the simulation
 * of the page as the robot. A proxy injects faults, which the checks must catch.
 */
import type { MazeDocument } from "@corridor/maze";
import { describe, expect, it, onTestFinished } from "vitest";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import {
  gatewayGroups,
  runChecks,
  type Result,
} from "../../../packages/conformance/src/run-checks.ts";
import { openSimulatedPage } from "../../support/client/simulated-page.ts";
import { gatewayFaults } from "../../support/conformance/gateway-faults.ts";
import { openGatewayProxy, type GatewayFault } from "../../support/conformance/gateway-proxy.ts";
import type { RelayProcess } from "../../support/relay-process.ts";
import { sharedRelayProcess, startRelayProcess } from "../../support/test-relay-process.ts";

const groups = Object.values(gatewayGroups);

/** the pen of docs/conformance.md */
const pen: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Pen",
  blocks: ["####", "#..#", "#..#", "#..#", "#..#", "#..#", "####"],
  start: { column: 2, row: 5, heading: "north" },
  goals: [{ column: 2, row: 1 }],
};

const sharedRelay = sharedRelayProcess();

/** @returns the address of a simulated robot in the pen */
async function robotInPen(relay: RelayProcess) {
  const registration = await registerRobot(relay.url, fetch);
  const robot = openSimulatedPage(relay.url, registration, pen);
  await expect.poll(() => robot.isConnected, { timeout: 10_000 }).toBe(true);
  const addressAt = (origin: string): string =>
    `${origin}/r/${registration.id}#${registration.driverKey}`;
  return addressAt;
}

async function behindProxy(fault: GatewayFault): Promise<string> {
  const relay = await sharedRelay();
  const addressAt = await robotInPen(relay);
  const proxy = await openGatewayProxy(relay.url, fault);
  onTestFinished(proxy.close);
  return addressAt(proxy.origin);
}

const failed = (results: readonly Result[]): Result[] =>
  results.filter(({ outcome }) => outcome.kind !== "passed");

describe("the gateways of a relay", () => {
  it("pass all checks", { timeout: 120_000 }, async () => {
    const relay = await sharedRelay();
    const addressAt = await robotInPen(relay);
    const results = await runChecks(addressAt(relay.url), { groups });
    expect(failed(results)).toEqual([]);
    expect(results).toHaveLength(groups.flatMap(({ checks }) => checks).length);
  });

  it("pass all checks through a proxy without a fault", { timeout: 120_000 }, async () => {
    expect(failed(await runChecks(await behindProxy({}), { groups }))).toEqual([]);
  });

  it("are reported as not offered if the operator has switched them off", async () => {
    const relay = await startRelayProcess({ environment: { GATEWAYS: "none" } });
    const addressAt = await robotInPen(relay);
    const results = await runChecks(addressAt(relay.url), { groups });
    const features = results.map(({ outcome }) =>
      outcome.kind === "not offered" ? outcome.feature : outcome,
    );
    expect(new Set(features)).toEqual(new Set(["ros", "mcp", "soap"]));
  });

  it.each(gatewayFaults)(
    "with a fault, $fault: caught by $caughtBy",
    { timeout: 60_000 },
    async ({ caughtBy, fault: _fault, ...fault }) => {
      const address = await behindProxy(fault);
      const only = groups.map((group) => ({
        ...group,
        checks: group.checks.filter(({ promise }) => promise === caughtBy),
      }));
      const results = await runChecks(address, { groups: only });
      expect(results).toMatchObject([{ promise: caughtBy, outcome: { kind: "failed" } }]);
    },
  );

  it("has an injected fault for every check", () => {
    const checks = groups.flatMap((group) => group.checks.map(({ promise }) => promise));
    expect([...new Set(gatewayFaults.map(({ caughtBy }) => caughtBy))]).toEqual(checks);
  });
});
