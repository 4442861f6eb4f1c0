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
import type { HelloTerms, Host } from "../host.ts";
import { must, shaped } from "../mismatch.ts";
import { areNear, atHome, readings, show, turned } from "../setting.ts";
import { mustLive } from "./events.ts";
import { FORWARD_MS, mustTake } from "./leases.ts";
import { messageFlow } from "./message-flow.ts";

const LEFT = { action: "left 90" } as const;
const RIGHT = { action: "right 90" } as const;
/** additional transit time of a command in ms, and a ttl that is shorter */
const HELD_MS = 1_500;
const SHORT_TTL = 1_000;
const SILENCE_MS = 8_000;

interface Door {
  feature: HostFeature & ("websocket" | "long-poll");
  /** prefix of the checks' names */
  over: string;
  open: OpenConnection;
  /** the response to an invalid hello: a close code or an HTTP status */
  refusals: { wrongKey: number; version: number };
  answerTo: (host: Host, hello: ReturnType<Host["hello"]>) => Promise<number | null>;
}

const doors: readonly Door[] = [
  {
    feature: "websocket",
    over: "over a WebSocket",
    open: openByWebSocket,
    refusals: { wrongKey: 4401, version: 4401 },
    answerTo: async (host, hello) => closeCodeAfter(host, JSON.stringify(hello)),
  },
  {
    feature: "long-poll",
    over: "over the long-poll connection",
    open: openByLongPoll,
    refusals: { wrongKey: 401, version: 400 },
    answerTo: async (host, body) =>
      (await host.ask("/long-poll", { method: "POST", key: null, body })).status,
  },
];

export const connections: CheckGroup = {
  title: "WebSocket and long-poll connection",
  checks: [
    ...doors.flatMap(checksOf),
    {
      promise: "long-poll-numbers",
      name: "over the long-poll connection, each message is taken once, and comes again until it is confirmed",
      needs: ["long-poll"],
      run: async (host) => {
        const opened = await host.ask("/long-poll", {
          method: "POST",
          key: null,
          body: host.hello(),
        });
        const { key } = shaped(openedConnectionSchema, opened.json, "an opened connection");
        const ask = async (path: string, method = "GET", body?: object) =>
          host.ask(`/long-poll${path}`, { method, key, ...(body !== undefined && { body }) });
        const { seq } = await host.done({ action: "stop" });
        const order = { action: "drive", left: 0, right: 0, milliseconds: 100 };
        const body = { first: 1, messages: [{ type: "command", command: order }] };
        for (let n = 0; n < 2; n++) {
          const { status, json } = await ask("/messages", "POST", body);
          must(status === 200, "200 for messages that are posted again", status);
          const { taken: number } = shaped(takenMessagesSchema, json, "how many were taken");
          must(number === 1, "message 1 taken, once", number);
        }
        await host.ended(seq + 1);
        const { status } = await host.ask(`/commands/${seq + 2}`);
        must(status === 404, "one command from a message that was posted twice", status);
        for (let n = 0; n < 2; n++) {
          const { json } = await ask("/messages?after=0&wait=1");
          const { first, messages } = shaped(fetchedMessagesSchema, json, "fetched messages");
          const isAgain = first === 1 && messages[0]?.type === "welcome";
          must(isAgain, "message 1 again, the welcome", json);
        }
        const left = await ask("", "DELETE");
        must(left.status === 204, "204 for DELETE", left.status);
        const over = await ask("/messages?after=0&wait=0");
        must([401, 404].includes(over.status), "401 or 404 once it is closed", over.status);
      },
    },
    ...messageFlow,
  ],
};

function checksOf({ feature, over, open, refusals, answerTo }: Door): Check[] {
  const check = (what: string, name: string, run: Check["run"]): Check => ({
    promise: `${feature}-${what}`,
    name: `${over}, ${name}`,
    needs: [feature],
    run,
  });
  /** Opens a connection, waits for its welcome, runs the callback and closes the connection. */
  const withOne = async <T>(
    host: Host,
    run: (connection: Connection) => Promise<T>,
    terms?: HelloTerms,
  ): Promise<T> => {
    const connection = await open(host, terms);
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
      "a command gets its ack and its states, the snapshot of the ending before the ending",
      async (host) => {
        const before = await readings(host);
        await withOne(host, async (connection) => {
          const { seq } = await taken(connection, host, LEFT);
          await ended(connection, seq);
          const { n } = await connection.message("welcome");
          mustFollow(connection, n ?? -1);
          mustLive(statesOf(connection), seq);
          const last = snapshotBeforeEnding(connection, seq);
          must(last?.command !== seq, "a snapshot from after the ending before it", last);
          const expected = turned(before, -1);
          const isNew = last !== undefined && areNear(last.sensors, expected);
          must(isNew, show(expected), last === undefined ? "no snapshot" : show(last.sensors));
        });
        await host.done(RIGHT);
      },
    ),
    check("retry", "the same key on the next connection is the same command", async (host) => {
      const key = host.newKey();
      const first = await withOne(host, async (it) => taken(it, host, LEFT, key));
      const again = await withOne(host, async (it) => taken(it, host, LEFT, key));
      must(again.seq === first.seq, `command ${first.seq}`, again.seq);
      must(again.duplicate, "duplicate: true", again.duplicate);
      await host.ended(first.seq);
      await host.done(RIGHT);
    }),
    check(
      "resume",
      "`since` in the hello brings everything that was missed, once",
      async (host) => {
        const since = await withOne(host, async (connection) => {
          const { seq } = await taken(connection, host, LEFT);
          await ended(connection, seq);
          const { stream } = await connection.message("welcome");
          return { stream, n: statesOf(connection).at(-1)?.n ?? 0 };
        });
        const { seq } = await host.done(RIGHT);
        const resume = async (connection: Connection): Promise<void> => {
          await ended(connection, seq);
          const { n } = await connection.message("welcome");
          must(n === since.n, `n ${since.n} in the welcome`, n);
          mustFollow(connection, since.n);
          mustLive(statesOf(connection), seq);
        };
        await withOne(host, resume, { since: `${since.stream}-${since.n}` });
      },
    ),
    check(
      "gap",
      "a reader that cannot be resumed gets a gap with the open commands",
      async (host) => {
        const { seq } = await host.send({
          action: "drive",
          left: 0,
          right: 0,
          milliseconds: 5_000,
        });
        const find = async (connection: Connection): Promise<void> => {
          const { n } = await connection.message("welcome");
          must(n === null, "n null in the welcome", n);
          const { open: commands } = await connection.message("gap");
          const seqs = commands.map((each) => each.seq);
          must(seqs.includes(seq), `command ${seq} among the open ones`, seqs);
        };
        await withOne(host, find, { since: "zzzzzzzz-1" });
        await host.done({ action: "stop" });
      },
    ),
    check(
      "problem",
      "a refusal names the key of its command, and the connection goes on",
      async (host) => {
        await withOne(host, async (connection) => {
          const key = host.newKey();
          await connection.send({ type: "command", key, command: { action: "fly" } });
          const { problem, key: named } = await connection.message("problem");
          must(problem.status === 400, "status 400", problem);
          must(named === key, `the key ${key}`, named);
          await taken(connection, host, { action: "stop" });
        });
      },
    ),
    check("transit", "`sentAt` counts: what was held up on its way is refused", async (host) => {
      const began = performance.now();
      const hold = async (connection: Connection): Promise<void> => {
        const key = host.newKey();
        const command = { ...LEFT, ttl: SHORT_TTL };
        await connection.send({ type: "command", key, sentAt: 0, command });
        const answer = await answerOf(connection, key);
        const isLate = answer.type === "problem" && answer.problem.status === 422;
        must(isLate, "a problem with status 422", answer);
        const sentAt = Math.round(HELD_MS + performance.now() - began);
        await taken(connection, host, { action: "stop" }, host.newKey(), sentAt);
      };
      await withOne(host, hold, { sentAt: HELD_MS });
    }),
    check("key", "a wrong key and another version of the protocol are refused", async (host) => {
      const wrongKey = await answerTo(host, host.hello({ key: host.wrongKey }));
      must(wrongKey === refusals.wrongKey, `${refusals.wrongKey} for a wrong key`, wrongKey);
      const version = await answerTo(host, host.hello({ version: 99 }));
      must(version === refusals.version, `${refusals.version} for version 99`, version);
    }),
    check(
      "silence",
      "`forward` ends 3 s after the last message, though the connection is open",
      async (host) => {
        await atHome(host);
        await withEvents(host, async (events) => {
          const connection = await open(host);
          const key = host.newKey();
          await connection.send({ type: "command", key, command: { action: "forward" } });
          const sentAt = performance.now();
          const end = await events.until(
            () => events.states.find(({ record }) => record.key === key && hasEnded(record.state)),
            SILENCE_MS,
            "forward to end",
          );
          must(end.record.state === "cancelled", "forward to end as cancelled", end.record);
          mustTake(end.at - sentAt, FORWARD_MS);
          await connection.close();
        });
      },
    ),
  ];
}

/** Sends a command, which the host must accept. @returns the record of the ack */
async function taken(
  connection: Connection,
  host: Host,
  command: Order,
  key = host.newKey(),
  sentAt?: number,
): Promise<CommandRecord> {
  await connection.send({ type: "command", key, command, ...(sentAt !== undefined && { sentAt }) });
  const answer = await answerOf(connection, key);
  if (answer.type === "ack") return answer.record;
  must(false, "an ack", answer);
}

/** The ack or the problem that answers a command. */
async function answerOf(connection: Connection, key: string) {
  return connection.until(
    () =>
      connection.received.find(
        (each) =>
          (each.type === "ack" && each.record.key === key) ||
          (each.type === "problem" && each.key === key),
      ),
    "an answer",
  );
}

async function ended(connection: Connection, seq: number): Promise<void> {
  await connection.message("state", ({ record }) => record.seq === seq && hasEnded(record.state));
}

function statesOf({ received }: Connection) {
  return received.flatMap((message) => (message.type === "state" ? [message] : []));
}

/** @throws Mismatch unless the numbers of the received states follow `n` without a gap */
function mustFollow(connection: Connection, n: number): void {
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
