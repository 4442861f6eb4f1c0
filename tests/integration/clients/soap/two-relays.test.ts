/** A SOAP client and the page of its robot at different relays. */
import { expect, it } from "vitest";
import { callSoap } from "../../../../apps/relay/src/testing/soap-client.ts";
import { startCluster } from "../../../support/client/cluster.ts";
import { corridor, corridorHost } from "../../../support/mcp/corridor-host.ts";

it("any relay serves a SOAP client: each call by another one than the last", async () => {
  const cluster = await startCluster();
  const [atPage, other] = [await cluster.startRelay(), await cluster.startRelay()];
  cluster.sendTo(atPage);
  const { registration } = await corridorHost({ url: cluster.origin }, corridor, atPage.url);
  const robot = registration.address;
  const move = { robot, action: "move", distance: 100, key: "step-0001", wait: 25 };
  const moved = await callSoap(other.url, "Command", move);
  expect(moved.fields).toMatchObject({ seq: "1", state: "completed", "pose.x": "250" });
  const again = await callSoap(atPage.url, "Command", move);
  expect(again.fields).toMatchObject({ seq: "1", state: "completed", duplicate: "true" });
  const sensed = await callSoap(other.url, "Sense", { robot });
  expect(sensed.fields).toMatchObject({ "pose.x": "250", bumps: "0" });
  const turned = await callSoap(atPage.url, "Command", { robot, action: "turn 180", wait: 25 });
  expect(turned.fields).toMatchObject({ seq: "2", state: "completed" });
  const log = await callSoap(other.url, "GetCommands", { robot });
  expect(log.text.match(/<commands>/g)).toHaveLength(2);
  const stopped = await callSoap(other.url, "Stop", { robot, wait: 25 });
  expect(stopped.fields).toMatchObject({ seq: "3", state: "completed" });
});
