import { snapshotOf } from "@corridor/protocol/testing";
import { expect, it, onTestFinished, vi } from "vitest";
import { ManualPort } from "../../../../../packages/ros/src/testing/manual-port.ts";
import { BridgedRobot } from "../bridged-robot.ts";
import { clock } from "../clock.ts";
import { openSession, type Connection } from "./open-session.ts";
import { readSensorSettings } from "./sensor-settings.ts";

function open(connection: Partial<Connection>) {
  const port = new ManualPort();
  port.newest = snapshotOf();
  const write = vi.spyOn(process.stderr, "write").mockReturnValue(true);
  onTestFinished(() => write.mockRestore());
  const session = openSession(new BridgedRobot(port), readSensorSettings({ unit: "cm" }), {
    unsent: () => 0,
    send: () => undefined,
    drop: () => undefined,
    ...connection,
  });
  if (session === null) throw new Error("no session");
  onTestFinished(() => session.close());
  return { session, printed: () => write.mock.calls.map(([text]) => String(text)) };
}

it("disconnects VIPLE if it does not read, with one line", async () => {
  const sent: string[] = [];
  const dropped = Promise.withResolvers<void>();
  const { session, printed } = open({
    unsent: () => 64 * 1024 + 1,
    send: (text) => sent.push(text),
    drop: () => {
      session.close();
      dropped.resolve();
    },
  });
  await dropped.promise;
  expect(sent).toEqual([]);
  expect(printed()).toEqual(["VIPLE does not read fast enough. It was disconnected.\n"]);
});

it("prints one line for a flood of wrong messages", () => {
  // A busy machine takes longer than a second, after which another line is due.
  const now = vi.spyOn(clock, "now").mockReturnValue(0);
  onTestFinished(() => now.mockRestore());
  const { session, printed } = open({});
  for (let i = 0; i < 10_000; i += 1) session.receive("nonsense");
  expect(printed()).toEqual(["A message of VIPLE is not one JSON object.\n"]);
});
