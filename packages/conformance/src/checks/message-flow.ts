/** Sizes, rates and keys of messages, over a WebSocket and a long-poll connection. */
import type { Check } from "../check.ts";
import {
  closeCodeAfter,
  MAX_BYTES,
  openByLongPoll,
  openByWebSocket,
  textOf,
  type Connection,
  type OpenConnection,
} from "../connection.ts";
import { pause, type Host } from "../host.ts";
import { must } from "../mismatch.ts";

/** Lasts longer than a check. */
const BUSY = { action: "drive", left: 0, right: 0, milliseconds: 60_000 } as const;
/** Time until the first heartbeat; the protocol promises one every 20 s. */
const HEARTBEAT_MS = { least: 15_000, most: 25_000 };
/** Maximum number of unacknowledged snapshots. */
const CREDIT = 2;
/** A moving robot reports about 20 times in this time. */
const UNACKNOWLEDGED_MS = 1_000;
const PACE_MS = 3_000;
/** Maximum number of snapshots a second, and a tolerance for snapshots that belong to a state. */
const PACE = 10;
const PACE_TOLERANCE = 5;

export const messageFlow: readonly Check[] = [
  {
    promise: "websocket-size",
    name: "over a WebSocket, a message of 16 KiB is accepted, and a larger one closes the connection with 1009",
    needs: ["websocket"],
    run: async (host) => {
      await mustAcceptLargest(host, openByWebSocket);
      const hello = JSON.stringify(host.hello());
      const code = await closeCodeAfter(host, hello, textOf({ type: "seen" }, MAX_BYTES + 1));
      must(code === 1009, "close code 1009 after a larger message", code);
    },
  },
  {
    promise: "websocket-seen",
    name: "over a WebSocket, at most 2 snapshots are sent without an acknowledgement",
    needs: ["websocket"],
    run: async (host) => {
      await withConnection(host, openByWebSocket, async (connection) => {
        const { snapshot } = await connection.message("welcome");
        const first = snapshot?.seq ?? 0;
        await connection.send({ type: "seen", seq: first });
        const key = host.newKey();
        await connection.send({ type: "command", key, command: BUSY });
        const { record } = await connection.message("ack", (ack) => ack.record.key === key);
        // Until the acknowledgement was processed, snapshots are not limited by it.
        const read = snapshotsOf(connection).at(-1)?.seq ?? first;
        await connection.send({ type: "seen", seq: read });
        await host.waitForStart(record.seq);
        await pause(UNACKNOWLEDGED_MS);
        await connection.wait();
        const unacknowledged = snapshotsOf(connection).filter(({ seq }) => seq > read);
        must(unacknowledged.length <= CREDIT, `at most ${CREDIT} snapshots`, unacknowledged.length);
        const newest = unacknowledged.at(-1)?.seq ?? read;
        await connection.send({ type: "seen", seq: newest });
        await connection.message("snapshot", (message) => message.snapshot.seq > newest);
      });
      await host.sendAndWait({ action: "stop" });
    },
  },
  {
    promise: "long-poll-size",
    name: "over the long-poll connection, a request of 16 KiB is accepted, and a larger one rejected with 413",
    needs: ["long-poll"],
    run: async (host) => {
      await mustAcceptLargest(host, openByLongPoll);
      const body = textOf(host.hello(), MAX_BYTES + 1);
      const { status } = await host.request("/long-poll", { method: "POST", key: null, body });
      must(status === 413, "413 for a larger request", status);
    },
  },
  {
    promise: "long-poll-key-wrong",
    name: "over the long-poll connection, another key neither reads nor sends messages",
    needs: ["long-poll"],
    run: async (host) => {
      await withConnection(host, openByLongPoll, async () => {
        const key = `con_${"A".repeat(22)}`;
        const path = "/long-poll/messages";
        const body = { first: 1, messages: [{ type: "command", command: { action: "stop" } }] };
        for (const options of [{ key }, { key, method: "POST", body }]) {
          const { status } = await host.request(path, options);
          must([401, 403, 404].includes(status), "401, 403 or 404 for another key", status);
        }
      });
    },
  },
  {
    promise: "long-poll-pace",
    name: "over the long-poll connection, at most 10 snapshots a second are sent",
    needs: ["long-poll"],
    run: async (host) => {
      await withConnection(host, openByLongPoll, async (connection) => {
        const { seq } = await host.send(BUSY);
        await host.waitForStart(seq);
        await connection.wait();
        const before = snapshotsOf(connection).length;
        const startedAt = performance.now();
        while (performance.now() - startedAt < PACE_MS) await connection.wait();
        const most = (PACE * (performance.now() - startedAt)) / 1_000 + PACE_TOLERANCE;
        const count = snapshotsOf(connection).length - before;
        must(count > 0 && count <= most, `1 to ${Math.round(most)} snapshots`, count);
      });
      await host.sendAndWait({ action: "stop" });
    },
  },
  {
    // The last check of its group, because it waits while the others run.
    promise: "websocket-heartbeat",
    name: "over a WebSocket, a heartbeat is sent every 20 s",
    needs: ["websocket"],
    onlyListens: true,
    run: async (host) => {
      await withConnection(host, openByWebSocket, async (connection) => {
        const opened = performance.now();
        await connection.message("heartbeat", () => true, HEARTBEAT_MS.most);
        const ms = performance.now() - opened;
        must(ms >= HEARTBEAT_MS.least, "a heartbeat after 20 s", `${Math.round(ms)} ms`);
      });
    },
  },
];

/** Opens a connection, waits for the welcome, and closes it afterwards. */
async function withConnection(
  host: Host,
  open: OpenConnection,
  run: (connection: Connection) => Promise<void>,
): Promise<void> {
  const connection = await open(host);
  try {
    await connection.message("welcome");
    await run(connection);
  } finally {
    await connection.close();
  }
}

async function mustAcceptLargest(host: Host, open: OpenConnection): Promise<void> {
  await withConnection(host, open, async (connection) => {
    const key = host.newKey();
    await connection.send({ type: "command", key, command: { action: "stop" } }, MAX_BYTES);
    await connection.message("ack", ({ record }) => record.key === key);
  });
}

function snapshotsOf({ received }: Connection) {
  return received.flatMap((each) => (each.type === "snapshot" ? [each.snapshot] : []));
}
