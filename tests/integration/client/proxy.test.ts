/** The library in Node, in a network with an obligatory proxy. */
import { execFile } from "node:child_process";
import { join } from "node:path";
import { promisify } from "node:util";
import { expect, it, onTestFinished } from "vitest";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { startForwardProxy } from "../../support/client/forward-proxy.ts";
import { GridRobot } from "../../support/client/grid-robot.ts";
import { startRelayProcess } from "../../support/test-relay-process.ts";

const SCRIPT = join(import.meta.dirname, "../../../examples/javascript/right-wall.ts");
const CORRIDOR = ["#####", "#...#", "#####"];

it("drives through the network's proxy if Node is configured to use it", async () => {
  const relay = await startRelayProcess();
  const registration = await registerRobot(relay.url, fetch);
  const robot = new GridRobot(relay.url, registration, CORRIDOR);
  onTestFinished(() => robot.connection.close());
  const proxy = await startForwardProxy(relay.url);
  const { pathname, hash } = new URL(registration.address);
  const args = [SCRIPT, `${proxy.service}${pathname}${hash}`, "--until-cells", "3"];
  const env = { ...process.env, ...proxy.env };
  const { stdout } = await promisify(execFile)(process.execPath, args, { env });
  expect(stdout).toMatch(/3 cells visited after \d+ moves\.\n$/);
  expect(robot.visited.size).toBe(3);
  expect(proxy.forwarded).toBeGreaterThan(0);
});
