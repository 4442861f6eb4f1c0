/** Robots and keys for tests of gateways. */
import { createdKeySchema, type Registration } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { completed } from "../platform/testing/messages.ts";
import { maze } from "../platform/testing/sample-documents.ts";
import { startTestRelay, type Requests } from "./test-relay.ts";
import { TestSocket } from "./test-socket.ts";

/** A relay with a robot whose page has reported. */
export async function reportedRobot() {
  const relay = await startTestRelay();
  const robot = await relay.register();
  const { socket: page, epoch } = await TestSocket.page(relay, robot);
  page.send({ type: "snapshot", epoch, snapshot: snapshotOf() });
  await relay.ask(robot, "/sensors?wait=5");
  await relay.ask(robot, "/maze", { method: "PUT", key: robot.ownerKey, body: maze });
  /** Starts the next command. */
  const start = async (): Promise<number> => {
    const { seq } = await page.next("command", "stop");
    page.send({ type: "started", epoch, seq });
    return Number(seq);
  };
  const end = (seq: number): void => {
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq: 100 + seq }) });
    page.send({ type: "ended", epoch, ...completed(seq) });
  };
  return { relay, robot, page, epoch, start, end };
}

/** Makes a key of the robot. */
export async function makeKey(
  relay: Requests,
  robot: Registration,
  kind: "drive" | "watch",
  use?: "url",
): Promise<{ id: string; key: string }> {
  const body = use === undefined ? { kind } : { kind, use };
  const made = await relay.ask(robot, "/keys", { method: "POST", key: robot.ownerKey, body });
  return createdKeySchema.parse(await made.json());
}
