/** A connection whose messages wait for the store, and one that exceeds its limit. */
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { limits } from "../../platform/limits/limits.ts";
import { completed } from "../../platform/testing/messages.ts";
import { startTestRelay } from "../../testing/test-relay.ts";
import { TestSocket } from "../../testing/test-socket.ts";
import { withBoundedQueue } from "./bounded-queue.ts";

function withSlowStore() {
  const closed: number[] = [];
  const begun: PromiseWithResolvers<void>[] = [];
  const conversation = withBoundedQueue(
    {
      received: () => {
        const work = Promise.withResolvers<void>();
        begun.push(work);
        return work.promise;
      },
      heartbeat: () => undefined,
      closed: () => undefined,
    },
    {
      get isOpen() {
        return closed.length === 0;
      },
      close: (code) => void closed.push(code),
    },
  );
  const send = (count: number): void => {
    for (let n = 0; n < count; n++) void conversation.received(Buffer.from("{}"));
  };
  const turn = (): Promise<void> => new Promise((resolve) => void setImmediate(resolve));
  return { send, begun, closed, turn };
}

describe("unfinished messages", () => {
  it("close their connection above the limit", async () => {
    const { send, closed, turn } = withSlowStore();
    send(limits.unfinishedMessages);
    await turn();
    expect(closed).toEqual([]);
    send(2);
    await turn();
    expect(closed).toEqual([4400]);
  });

  it("do not count after they are processed", async () => {
    const { send, begun, closed, turn } = withSlowStore();
    for (let n = 0; n < 3; n++) {
      send(limits.unfinishedMessages);
      for (const work of begun.splice(0)) work.resolve();
      await turn();
    }
    expect(closed).toEqual([]);
  });

  it("close a page that reports thousands of commands at once", async () => {
    const relay = await startTestRelay();
    const { socket, epoch } = await TestSocket.page(relay, await relay.register());
    for (let seq = 1; seq <= 5_000; seq++) socket.send({ type: "started", epoch, seq });
    expect((await socket.closed).code).toBe(4400);
  });

  it("do not include snapshots that a network delayed", async () => {
    const relay = await startTestRelay();
    const { socket, epoch } = await TestSocket.page(relay, await relay.register());
    for (let seq = 1; seq <= 5 * limits.unfinishedMessages; seq++)
      socket.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq }) });
    socket.send({ type: "ended", epoch, ...completed(77) });
    expect(await socket.next("stored")).toEqual({ type: "stored", seq: 77 });
  });
});
