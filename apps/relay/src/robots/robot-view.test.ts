import { snapshotOf } from "@corridor/protocol/testing";
import { expect, it } from "vitest";
import { readSnapshotMessage, type CarriedSnapshot } from "../bus/carried-snapshot.ts";
import { limits } from "../platform/limits/limits.ts";
import { RobotView } from "./robot-view.ts";

function reported(seq: number, tick: number): CarriedSnapshot {
  const message = { type: "snapshot", epoch: 1, snapshot: snapshotOf({ seq, tick }) };
  const read = readSnapshotMessage(Buffer.from(JSON.stringify(message)));
  if (read === null) throw new Error("a page's snapshot was not recognised");
  return read.snapshot;
}

it("reports a silent robot as paused or disconnected until it reports again", () => {
  const view = new RobotView();
  view.pageConnected(0, 0);
  view.report(reported(1, 60), 0);
  expect(view.newest).toMatchObject({ seq: 1, state: "running" });
  expect(view.checkAsleep(limits.asleepMs + 1)).toBe(true);
  expect(view.newest).toMatchObject({ seq: 1, state: "paused" });
  view.report(reported(2, 60), limits.asleepMs + 2);
  expect(view.newest).toMatchObject({ seq: 2, state: "paused" });
  view.report(reported(3, 61), limits.asleepMs + 3);
  expect(view.newest).toMatchObject({ seq: 3, state: "running" });
  view.pageLeft();
  expect(view.newest).toMatchObject({ seq: 3, state: "gone" });
  expect(view.newest?.value.state).toBe("gone");
  view.pageConnected(10_000, 0);
  expect(view.newest).toMatchObject({ seq: 3, state: "paused" });
});

it("needs no more memory for a disconnected robot than its snapshot", () => {
  const view = new RobotView();
  view.pageConnected(0, 0);
  view.report(reported(1, 60), 0);
  view.pageLeft();
  const { frame } = view.newest ?? { frame: Buffer.alloc(0) };
  expect(frame.length).toBeGreaterThan(200);
  expect(frame.buffer.byteLength).toBe(frame.length);
});
