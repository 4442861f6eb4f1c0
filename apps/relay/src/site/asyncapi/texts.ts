/**
 * Texts of the AsyncAPI description about robots, and the shape of the texts of any channel. They
 * match /docs/transports and /docs/host-connection.
 */
import { closeReasons } from "@corridor/protocol";
import type { MessageKinds } from "./examples.ts";

/** @template K the messages of each side, by the name of the side */
export interface ChannelTexts<K extends Record<keyof K, { type: string }>> {
  channel: { title: string; summary: string; description: string };
  /** summary and message order of each side */
  operations: Readonly<Record<keyof K, { summary: string; description: string }>>;
  messages: { [S in keyof K]: Readonly<Record<K[S]["type"], string>> };
}

export const DESCRIPTION = `One connection for each page and each script of a robot, and for each student, dashboard and big
screen of a class. The first message of a client is \`hello\`, within 5 s. A page then sends \`resume\`. The relay responds
with \`welcome\`. Each message is one JSON text of at most 16 KiB, \`hello\` of at most 1 KiB. Networks that block
WebSockets can use the same messages over HTTPS: see \`/long-poll\` in \`/openapi.json\`. For guides, see
\`/docs/transports\`, \`/docs/host-connection\` and \`/docs/classes\`.

Lengths are in cm, angles in degrees clockwise from north, x to the right and y downward. Times are in ms. A tick is 1/60 s.`;

const SCRIPT_ORDER = `1. Send \`hello\`. The relay responds with \`welcome\`, followed by a \`gap\` if states were missed.
2. Send \`command\`, any number of times. The relay responds to each with \`ack\` or \`problem\`, identified by its \`key\`.
   Responses may arrive in another order than the commands.
3. At any time, receive \`state\` for every command of the robot, numbered without gaps, and \`snapshot\`, which you
   acknowledge with \`seen\`. The snapshot of a final state arrives before its \`state\`.`;

const PAGE_ORDER = `1. Send \`hello\`, then \`resume\`. The relay responds with one \`welcome\`, after another page has released the
   robot (\`yield\`, \`yielded\`).
2. Receive \`command\` and \`stop\`. For each, send \`started\` and \`ended\`, or only \`ended\`. The relay responds to each
   \`ended\` with \`stored\` or \`refused\`. Until then, send it again on the next connection.
3. At any time, send \`snapshot\` of the robot, and receive \`drivers\` about once a second.`;

export const robotTexts: ChannelTexts<MessageKinds> = {
  channel: {
    title: "A robot's WebSocket",
    summary: "Commands to a robot, and its reports.",
    description: `Order of messages for a script:

${SCRIPT_ORDER}

Order of messages for a page:

${PAGE_ORDER}

Both receive \`heartbeat\` every 20 s; after 45 s without a message the connection is lost. Reconnect after a random delay
of up to 0.25 s that doubles up to 10 s, but never exceeds twice the time since the connection was lost.

${closeCodes()}`,
  },
  operations: {
    script: {
      summary: "A script authenticates, sends commands, and acknowledges snapshots.",
      description: SCRIPT_ORDER,
    },
    page: {
      summary: "A page authenticates, reports its progress, and then reports the robot's state.",
      description: PAGE_ORDER,
    },
    toScript: {
      summary: "A script receives records, states, snapshots and maze changes.",
      description: SCRIPT_ORDER,
    },
    toPage: { summary: "A page receives commands for the robot.", description: PAGE_ORDER },
  },
  messages: {
    script: {
      hello:
        "The first message, which authenticates the client. `role` is `drive` with a driver key, `watch` with a watch key (or a driver key). " +
        "`since` is the last state that the script received, STREAM-n, to resume there. `name` is displayed to the robot's owner. `sentAt`: see `command`.",
      command:
        "A command. A repeated `key` with the same command returns the first record, so a retry never moves the robot twice. A retry sends its age in " +
        "`age`. `sentAt`, in each attempt and in `hello`, is the time of the script's monotonic clock. Transit time beyond that of the " +
        "fastest message of the connection counts towards `ttl`. The relay responds with `ack` or `problem`.",
      seen:
        "Acknowledges all messages up to this snapshot, including the one in the welcome. At most 2 unacknowledged snapshots are sent to a " +
        "script. It is cumulative: send it for each snapshot or for every second one, not less often. For a script that never sends it, " +
        "the pongs to the relay's pings count.",
      marks:
        "Draws over cells of the robot's maze: a text, a colour and assumed walls. Each cell replaces its earlier marks; the first message of a " +
        "connection, or one with `fresh`, removes all others first. At most 10 a second. They are not stored, so repeat them: they end with the connection, and 5 s after the last message.",
    },
    page: {
      hello:
        "The first message, which authenticates the page. `role` is `own`, with the owner key.",
      resume:
        "Follows `hello`: the page's progress so far, and the robot's current state. `lastApplied`: this command and every earlier one " +
        "that the page received have started or ended. `endings`: final states that the relay has not confirmed as stored. `page`: a random " +
        "id that identifies the page on its next connection.",
      snapshot:
        "The current state of the robot. Without a new snapshot for 3.5 s, the robot's `state` is `paused`.",
      started: "The robot has started this command, before its deadline by the robot's clock.",
      ended:
        "The final state of a command, with pose, distance and reason: `completed`, `collided`, `cancelled`, `superseded` or " +
        "`expired`. The relay responds with `stored` or `refused`. The first final state is permanent.",
      time: "Requests the relay's time, because an earlier response took so long that delays are uncertain.",
      yielded:
        "The response to `yield`: this page has reported everything that it started, and starts nothing more.",
    },
    toScript: {
      welcome:
        "The response to `hello`. States after `n` follow. If `n` is null, states were missed, and a `gap` follows. " +
        "`snapshot` is null until the robot has reported.",
      ack:
        "The command is stored. After a retry, the record contains the current state of the command, " +
        "which may be final, and `duplicate` is true.",
      state:
        "A command of this robot, from any sender, has a new state. `n` increases by one each time. With the stream of the " +
        "welcome, STREAM-n is the value of `since` for a reconnection.",
      gap:
        "Replaces states that are no longer stored. `open` contains the commands that have not ended, `n` is the number from which to " +
        "continue. All other commands have ended: read their records with `GET /commands/SEQ`.",
      snapshot:
        "The robot's latest report, at most 20 a second; reports in between are skipped. `state` is `running`, `paused` " +
        "(the page is asleep, frozen or paused) or `gone`.",
      maze: "The robot's maze has changed. `GET /maze` returns it with this `version` as its `ETag`.",
      marks:
        "To viewers only: a script has drawn marks over cells of the maze. `fresh` without cells: its marks have ended.",
      problem:
        "The message was rejected (RFC 9457). `key` is the key of its command, or null if it has no readable key.",
      heartbeat: "Sent every 20 s, as evidence that the connection works.",
    },
    toPage: {
      welcome:
        "The response to `hello` and `resume`: the page now owns the robot. All messages of the page contain this `epoch`, which increases with each " +
        "connection of a page. `at` is the relay's time in all messages. The page derives from it how long a later message was delayed.",
      command:
        "A command for the robot, which must start within `remaining` ms by the robot's own clock, or end as `expired`. At most 8 are " +
        "delivered at a time. With `replace` it ends all earlier commands.",
      stop: "A stop. The page ends its running and waiting commands, and then the stop as `completed`.",
      cancel:
        "Asks the page to end this command. `cause` is `sender`, or what the owner did: `revoked` the key, `blocked` the script, or " +
        "`paused` remote driving. The page responds with `ended`.",
      stored: "The final state of this command is stored. The page may discard it.",
      refused: "The reported final state arrived too late. The record contains the permanent one.",
      state:
        "The state of a command that the page does not hold: it waits at the relay or has ended there. Sent immediately at low " +
        "load, and once a second in batches at high load; always before the next `command` or `stop`, and before the " +
        "`stored` of a `cancelled` command.",
      drivers:
        "The robot's scripts, about once a second. `scripts` lists them. `alive` is the last activity of each key, because motions without " +
        "an end stop when their script becomes inactive. `paused`: the owner has paused remote driving.",
      time: "The response to `time`: the relay's clock.",
      yield:
        "Another page is about to take over the robot. End the running command, return waiting commands, start nothing more, report all of " +
        "that, and send `yielded`, within a second.",
      marks:
        "A script has drawn marks over cells of the maze. `fresh` without cells: its marks have ended.",
      heartbeat: "Sent every 20 s, as evidence that the connection works.",
    },
  },
};

/**
 * The list of close codes.
 * @param causes of a channel, in place of those of a robot; null: the code does not occur
 */
export function closeCodes(
  causes: Partial<Record<keyof typeof closeReasons, string | null>> = {},
): string {
  const ofChannel = new Map(Object.entries(causes));
  const lines = Object.entries(closeReasons).flatMap(([name, { code, cause, retry }]) => {
    const text = ofChannel.has(name) ? ofChannel.get(name) : cause;
    return typeof text === "string"
      ? `- ${code}: ${text}${retry ? "" : " (do not reconnect)"}`
      : [];
  });
  return ["Close codes:", ...lines].join("\n");
}
