/** Connections: the same messages by WebSocket and by long poll. */
import {
  fetchedMessagesSchema,
  hasEnded,
  openedConnectionSchema,
  takenMessagesSchema,
  type CommandRecord,
  type HostFeature,
  type Order,
} from "@corridor/protocol";
import type { Check, CheckGroup } from "../check.ts";
import {
  closeCodeAfter,
  openByLongPoll,
  openByWebSocket,
  type Connection,
  type OpenConnection,
} from "../connection.ts";
import { withEvents } from "../event-stream.ts";
import type { HelloOptions, Host } from "../host.ts";
import { must, validate } from "../mismatch.ts";
import { areNear, moveToStart, readings, show, turned } from "../pen.ts";
import { mustFollowLifeCycle } from "./events.ts";
import { FORWARD_MS, mustLast } from "./leases.ts";
import { messageFlow } from "./message-flow.ts";

const LEFT = { action: "left 90" } as const;
const RIGHT = { action: "right 90" } as const;
/** additional transit time of a command in ms, and a ttl that is shorter */
const DELAY_MS = 1_500;
const SHORT_TTL = 1_000;
const END_MS = 8_000;

interface Transport {
  feature: HostFeature & ("websocket" | "long-poll");
  /** prefix of the checks' names */
  label: string;
  open: OpenConnection;
  /** the response to an invalid hello: a close code or an HTTP status */
  rejections: { wrongKey: number; version: number };
  respond: (host: Host, hello: ReturnType<Host["hello"]>) => Promise<number | null>;
}

const transports: readonly Transport[] = [
  {
    feature: "websocket",
    label: "over a WebSocket",
    open: openByWebSocket,
    rejections: { wrongKey: 4401, version: 4401 },
    respond: async (host, hello) => closeCodeAfter(host, JSON.stringify(hello)),
  },
  {
    feature: "long-poll",
    label: "over the long-poll connection",
    open: openByLongPoll,
    rejections: { wrongKey: 401, version: 400 },
    respond: async (host, body) =>
      (await host.request("/long-poll", { method: "POST", key: null, body })).status,
  },
];

export const connections: CheckGroup = {
  title: "WebSocket and long-poll connection",
  checks: [
    ...transports.flatMap(checksOf),
    {
      promise: "long-poll-numbers",
      name: "over the long-poll connection, each message is processed once, and sent again until it is acknowledged",
      needs: ["long-poll"],
      run: async (host) => {
        const opened = await host.request("/long-poll", {
          method: "POST",
          key: null,
          body: host.hello(),
        });
        const { key } = validate(openedConnectionSchema, opened.json, "an opened connection");
        const request = async (path: string, method = "GET", body?: object) =>
          host.request(`/long-poll${path}`, { method, key, ...(body !== undefined && { body }) });
        const { seq } = await host.sendAndWait({ action: "stop" });
        const order = { action: "drive", left: 0, right: 0, milliseconds: 100 };
        const body = { first: 1, messages: [{ type: "command", command: order }] };
        for (let n = 0; n < 2; n++) {
          const { status, json } = await request("/messages", "POST", body);
          must(status === 200, "200 for messages that are posted twice", status);
          const { taken: number } = validate(
            takenMessagesSchema,
            json,
            "the number of accepted messages",
          );
          must(number === 1, "message 1 accepted, once", number);
        }
        await host.waitForEnd(seq + 1);
        const { status } = await host.request(`/commands/${seq + 2}`);
        must(status === 404, "one command from a message that was posted twice", status);
        for (let n = 0; n < 2; n++) {
          const { json } = await request("/messages?after=0&wait=1");
          const { first, messages } = validate(fetchedMessagesSchema, json, "fetched messages");
          const isRepeated = first === 1 && messages[0]?.type === "welcome";
          must(isRepeated, "message 1 again, the welcome", json);
        }
        const closed = await request("", "DELETE");
        must(closed.status === 204, "204 for DELETE", closed.status);
        const afterwards = await request("/messages?after=0&wait=0");
        must(
          [401, 404].includes(afterwards.status),
          "401 or 404 once it is closed",
          afterwards.status,
        );
      },
    },
    ...messageFlow,
  ],
};

function checksOf({ feature, label, open, rejections, respond }: Transport): Check[] {
  const check = (what: string, name: string, run: Check["run"]): Check => ({
    promise: `${feature}-${what}`,
    name: `${label}, ${name}`,
    needs: [feature],
    run,
  });
  /** Opens a connection, waits for its welcome, runs the callback and closes the connection. */
  const withConnection = async <T>(
    host: Host,
    run: (connection: Connection) => Promise<T>,
    options?: HelloOptions,
  ): Promise<T> => {
    const connection = await open(host, options);
    try {
      await connection.message("welcome");
      return await run(connection);
    } finally {
      await connection.close();
    }
  };
  return [
    check(
      "command",
      "a command receives its ack and its states, and the snapshot of the final state before that state",
      async (host) => {
        const before = await readings(host);
        await withConnection(host, async (connection) => {
          const { seq } = await sendCommand(connection, host, LEFT);
          await waitForEnd(connection, seq);
          const { n } = await connection.message("welcome");
          mustBeConsecutive(connection, n ?? -1);
          mustFollowLifeCycle(statesOf(connection), seq);
          const last = snapshotBeforeEnding(connection, seq);
          must(
            last?.command !== seq,
            "before the final state, a snapshot without the command",
            last,
          );
          const expected = turned(before, -1);
          const isNew = last !== undefined && areNear(last.sensors, expected);
          must(isNew, show(expected), last === undefined ? "no snapshot" : show(last.sensors));
        });
        await host.sendAndWait(RIGHT);
      },
    ),
    check("retry", "the same key on the next connection is the same command", async (host) => {
      const key = host.newKey();
      const first = await withConnection(host, async (it) => sendCommand(it, host, LEFT, key));
      const again = await withConnection(host, async (it) => sendCommand(it, host, LEFT, key));
      must(again.seq === first.seq, `command ${first.seq}`, again.seq);
      must(again.duplicate, "duplicate: true", again.duplicate);
      await host.waitForEnd(first.seq);
      await host.sendAndWait(RIGHT);
    }),
    check(
      "resume",
      "`since` in the hello resumes: each missed state arrives once",
      async (host) => {
        const since = await withConnection(host, async (connection) => {
          const { seq } = await sendCommand(connection, host, LEFT);
          await waitForEnd(connection, seq);
          const { stream } = await connection.message("welcome");
          return { stream, n: statesOf(connection).at(-1)?.n ?? 0 };
        });
        const { seq } = await host.sendAndWait(RIGHT);
        const resume = async (connection: Connection): Promise<void> => {
          await waitForEnd(connection, seq);
          const { n } = await connection.message("welcome");
          must(n === since.n, `n ${since.n} in the welcome`, n);
          mustBeConsecutive(connection, since.n);
          mustFollowLifeCycle(statesOf(connection), seq);
        };
        await withConnection(host, resume, { since: `${since.stream}-${since.n}` });
      },
    ),
    check(
      "gap",
      "a reader that cannot resume receives a gap with the open commands",
      async (host) => {
        const { seq } = await host.send({
          action: "drive",
          left: 0,
          right: 0,
          milliseconds: 5_000,
        });
        const checkGap = async (connection: Connection): Promise<void> => {
          const { n } = await connection.message("welcome");
          must(n === null, "n null in the welcome", n);
          const { open: commands } = await connection.message("gap");
          const seqs = commands.map((each) => each.seq);
          must(seqs.includes(seq), `command ${seq} among the open ones`, seqs);
        };
        await withConnection(host, checkGap, { since: "zzzzzzzz-1" });
        await host.sendAndWait({ action: "stop" });
      },
    ),
    check(
      "problem",
      "a problem contains the key of its command, and the connection stays open",
      async (host) => {
        await withConnection(host, async (connection) => {
          const key = host.newKey();
          await connection.send({ type: "command", key, command: { action: "fly" } });
          const { problem, key: named } = await connection.message("problem");
          must(problem.status === 400, "status 400", problem);
          must(named === key, `the key ${key}`, named);
          await sendCommand(connection, host, { action: "stop" });
        });
      },
    ),
    check(
      "transit",
      "with `sentAt`, transit time counts: a delayed command is rejected",
      async (host) => {
        const startedAt = performance.now();
        const delay = async (connection: Connection): Promise<void> => {
          const key = host.newKey();
          const command = { ...LEFT, ttl: SHORT_TTL };
          await connection.send({ type: "command", key, sentAt: 0, command });
          const response = await responseTo(connection, key);
          const isLate = response.type === "problem" && response.problem.status === 422;
          must(isLate, "a problem with status 422", response);
          const sentAt = Math.round(DELAY_MS + performance.now() - startedAt);
          await sendCommand(connection, host, { action: "stop" }, host.newKey(), sentAt);
        };
        await withConnection(host, delay, { sentAt: DELAY_MS });
      },
    ),
    check("key", "a wrong key and another version of the protocol are rejected", async (host) => {
      const wrongKey = await respond(host, host.hello({ key: host.wrongKey }));
      must(wrongKey === rejections.wrongKey, `${rejections.wrongKey} for a wrong key`, wrongKey);
      const version = await respond(host, host.hello({ version: 99 }));
      must(version === rejections.version, `${rejections.version} for version 99`, version);
    }),
    check(
      "silence",
      "`forward` ends 3 s after the last message, although the connection is open",
      async (host) => {
        await moveToStart(host);
        await withEvents(host, async (events) => {
          const connection = await open(host);
          const key = host.newKey();
          await connection.send({ type: "command", key, command: { action: "forward" } });
          const sentAt = performance.now();
          const end = await events.until(
            () => events.states.find(({ record }) => record.key === key && hasEnded(record.state)),
            END_MS,
            "forward to end",
          );
          must(end.record.state === "cancelled", "forward to end as cancelled", end.record);
          mustLast(end.at - sentAt, FORWARD_MS);
          await connection.close();
        });
      },
    ),
  ];
}

/** Sends a command, which the host must accept. @returns the record of the ack */
async function sendCommand(
  connection: Connection,
  host: Host,
  command: Order,
  key = host.newKey(),
  sentAt?: number,
): Promise<CommandRecord> {
  await connection.send({ type: "command", key, command, ...(sentAt !== undefined && { sentAt }) });
  const response = await responseTo(connection, key);
  if (response.type === "ack") return response.record;
  must(false, "an ack", response);
}

/** The ack or the problem in response to a command. */
async function responseTo(connection: Connection, key: string) {
  return connection.until(
    () =>
      connection.received.find(
        (each) =>
          (each.type === "ack" && each.record.key === key) ||
          (each.type === "problem" && each.key === key),
      ),
    "a response",
  );
}

async function waitForEnd(connection: Connection, seq: number): Promise<void> {
  await connection.message("state", ({ record }) => record.seq === seq && hasEnded(record.state));
}

function statesOf({ received }: Connection) {
  return received.flatMap((message) => (message.type === "state" ? [message] : []));
}

/** @throws Mismatch unless the numbers of the received states follow `n` without a gap */
function mustBeConsecutive(connection: Connection, n: number): void {
  const numbers = statesOf(connection).map((state) => state.n);
  const isWhole = numbers.every((each, index) => each === n + index + 1);
  must(isWhole, `states numbered on from ${n}`, numbers);
}

function snapshotBeforeEnding({ received }: Connection, seq: number) {
  const ending = received.findIndex(
    (each) => each.type === "state" && each.record.seq === seq && hasEnded(each.record.state),
  );
  const before = received.slice(0, ending);
  return before.flatMap((each) => (each.type === "snapshot" ? [each.snapshot] : [])).at(-1);
}
