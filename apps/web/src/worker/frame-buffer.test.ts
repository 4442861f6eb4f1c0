import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { SimulatorClient, type WorkerPort } from "./simulator-client.ts";
import { frameOf } from "./testing/frame-of.ts";
import type { Frame, FromWorker } from "./worker-messages.ts";

const snapshot = snapshotOf();

function connect(): { client: SimulatorClient; receive: (frame: Frame) => void } {
  const port: WorkerPort = { postMessage: () => {}, onmessage: null };
  const client = new SimulatorClient(port);
  const receive = (frame: Frame): void => {
    const message: FromWorker = { type: "frame", frame };
    port.onmessage?.(new MessageEvent("message", { data: message }));
  };
  return { client, receive };
}

describe("the newest frame", () => {
  it("comes with all that the trail gained since the last one was taken", () => {
    const { client, receive } = connect();
    expect(client.takeFrame()).toBeNull();
    receive(frameOf({ snapshot, corners: [1, 2], bumps: [5, 6], trailReset: true }));
    receive(frameOf({ snapshot: { ...snapshot, tick: 2 }, corners: [3, 4], bumps: [7, 8] }));
    expect(client.takeFrame()).toMatchObject({
      snapshot: { tick: 2 },
      corners: [1, 2, 3, 4],
      bumps: [5, 6, 7, 8],
      trailReset: true,
    });
    expect(client.takeFrame()).toMatchObject({ corners: [], bumps: [], trailReset: false });
  });

  it("forgets the trail from before the robot was put back to its start", () => {
    const { client, receive } = connect();
    receive(frameOf({ snapshot, corners: [1, 2], trailReset: false }));
    receive(frameOf({ snapshot, corners: [9, 9], trailReset: true }));
    expect(client.takeFrame()).toMatchObject({ corners: [9, 9], trailReset: true });
  });

  it("keeps only the newest part of the trail when the page was hidden for hours", () => {
    const { client, receive } = connect();
    const corners = Array.from({ length: 60_000 }, (_, i) => i);
    receive(frameOf({ snapshot, corners, trailReset: false }));
    const frame = client.takeFrame();
    expect(frame?.corners).toHaveLength(40_000);
    expect(frame?.corners.at(-1)).toBe(59_999);
    expect(frame?.trailReset).toBe(true);
  });
});
