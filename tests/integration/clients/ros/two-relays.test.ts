/** A ROS client and the page of its robot at different relays. */
import { expect, it } from "vitest";
import { RosClient } from "../../../../apps/relay/src/testing/ros-client.ts";
import { corridor, corridorHost } from "../../../support/mcp/corridor-host.ts";
import { startCluster } from "../../../support/client/cluster.ts";

it("any relay serves a ROS client: it reads, drives and receives results", async () => {
  const cluster = await startCluster();
  const [atPage, other] = [await cluster.startRelay(), await cluster.startRelay()];
  cluster.sendTo(atPage);
  const { registration } = await corridorHost({ url: cluster.origin }, corridor, atPage.url);
  const client = await RosClient.connect({ origin: other.url }, registration);
  client.send({ op: "subscribe", topic: "/pose2d" });
  expect((await client.next("topic", "/pose2d"))["msg"]).toMatchObject({ x: 1.5, y: 5.5 });
  client.send({ op: "send_action_goal", id: "g", action: "/move", args: { distance: 1 } });
  expect(await client.next("op", "action_result")).toMatchObject({
    status: 4,
    values: { state: "completed", x: 2.5 },
  });
  expect(await client.call("/reset")).toMatchObject({ result: true, values: { success: true } });
});
