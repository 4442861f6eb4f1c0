/** What is said of the WebSocket and its messages in the description for machines: in the words of docs/protocol.md. */
import { closeReasons } from "@corridor/protocol";
import type { MessageKinds } from "./examples.ts";

export const TITLE = "One WebSocket for each page and each script of a robot";

export const DESCRIPTION = `${TITLE}. Its first message, within 5 s, is \`hello\`: a page goes on with \`resume\`. The
relay answers with \`welcome\`. Each message is one JSON text of at most 16 KiB, \`hello\` at most 1 KiB. Where no
WebSocket passes, the same messages go by plain HTTPS: see \`/line\` in \`/openapi.json\`. \`/docs\` has all of this in words.

Lengths are in cm, angles in degrees clockwise from north, x to the right and y downward; times are in ms. A tick is 1/60 s.`;

const SCRIPT_ORDER = `1. \`hello\`, answered by \`welcome\`; by a \`gap\` right after it where states were missed.
2. \`command\`, as often as is wished. Each is answered by \`ack\` or \`problem\`, by its \`key\`: answers may come in another
   order than the commands.
3. Meanwhile \`state\` of every command of the robot, numbered without a gap, and \`snapshot\`, which is said by \`seen\`.
   The snapshot that belongs to an ending comes before its \`state\`.`;

const PAGE_ORDER = `1. \`hello\` and right after it \`resume\`, answered by one \`welcome\`, once another page has given the robot up
   (\`yield\`, \`yielded\`).
2. \`command\` and \`stop\` come; for each \`started\` and \`ended\`, or \`ended\` alone. Each ending is answered by
   \`stored\` or \`refused\`, and told again on the next line until then.
3. Meanwhile \`snapshot\` of the robot, and \`drivers\` about once a second.`;

export const CHANNEL = {
  title: "A robot's WebSocket",
  summary: "Commands to a robot, and what it reports.",
  description: `A script speaks in this order:

${SCRIPT_ORDER}

A page speaks in this order:

${PAGE_ORDER}

Both hear \`heartbeat\` every 20 s; 45 s of silence mean that the line is lost. Reconnect after a random pause of up to
0.25 s that doubles up to 10 s, but is never more than twice the time since the line was lost.

${closeCodes()}`,
};

/** What each side says or hears, in short and in order. */
export const OPERATIONS: Readonly<
  Record<keyof MessageKinds, { summary: string; description: string }>
> = {
  script: {
    summary: "A script says hello, sends commands, and says which snapshots it has read.",
    description: SCRIPT_ORDER,
  },
  page: {
    summary: "A page says hello, what it has done so far, and then what the robot does.",
    description: PAGE_ORDER,
  },
  toScript: {
    summary: "A script hears records, states and snapshots, and of another maze.",
    description: SCRIPT_ORDER,
  },
  toPage: { summary: "A page hears what the robot is to do.", description: PAGE_ORDER },
};

export const MESSAGE_WORDS: {
  [S in keyof MessageKinds]: Readonly<Record<MessageKinds[S]["type"], string>>;
} = {
  script: {
    hello:
      "The first message: who speaks, and by what right. `role` is `drive` with a driver key, `watch` with a watch key (or a driver key). " +
      "`since` is the last state that it was told, STREAM-n, to go on from there; `name` is what the robot's owner sees. `sentAt`: see `command`.",
    command:
      "A command. The same `key` with the same command gives the first record again, so a retry never moves the robot twice; it says how old it " +
      "is by `age`. `sentAt`, in each try and in `hello`, is the time by the script's monotonic clock: what a command takes longer than the " +
      "quickest message of the connection counts for its `ttl`. It is answered by `ack` or `problem`.",
    seen:
      "All that came up to this snapshot was read, the one in the welcome too. At most 2 snapshots are on their way to a " +
      "script. Since it is cumulative, it may be said for each snapshot or for every second one, never for fewer. For a script that never says it, " +
      "the answers to the relay's pings count.",
  },
  page: {
    hello: "The first message: who speaks, and by what right. `role` is `own`, with the owner key.",
    resume:
      "Right after `hello`: what the page has done so far, and the robot as it is now. `lastApplied`: this command and every earlier one " +
      "that it was given have begun or ended. `endings` are those of which it does not know that they are stored. By `page`, drawn by " +
      "chance by each page, it is known on its next line.",
    snapshot: "The robot as it is now. A page that says nothing new for 3.5 s counts as asleep.",
    started: "The robot has begun this command: by its own clock there was time left.",
    ended:
      "How the command ended, with pose, distance and reason: `completed`, `collided`, `cancelled`, `superseded` or " +
      "`expired`. It is answered by `stored` or `refused`. The first ending stands for ever.",
    time: "Asks for the relay's time, because an earlier answer took so long that delays are in doubt.",
    yielded:
      "The answer to `yield`: all that this page has begun was told before, and it begins nothing any more.",
  },
  toScript: {
    welcome:
      "The answer to `hello`. States after `n` follow; null means that states were missed, and a `gap` follows. " +
      "`snapshot` is null until the robot has reported.",
    ack:
      "The command is stored: only then it is answered. After a retry the record tells the state that the command has by " +
      "then, which may be its ending, and `duplicate` is true.",
    state:
      "A command of this robot, whoever sent it, has a new state. `n` rises by one each time; with the stream of the " +
      "welcome, STREAM-n is what to come back with as `since`.",
    gap:
      "In place of states that are not kept any more: the commands that have not ended, and the `n` to go on from. Every " +
      "other command has ended; `GET /commands/SEQ` tells how.",
    snapshot:
      "The newest that the robot reported, at most 20 a second; what came in between is left out. `state` is `running`, `paused` " +
      "(the page is asleep, frozen or paused) or `gone`.",
    maze: "The robot is in another maze: the one that `GET /maze` answers with this `version` as its `ETag`.",
    problem:
      "The message could not be served (RFC 9457). `key` is that of its command, or null where there is none that can be read.",
    heartbeat: "Nothing has happened for 20 s, and the line lives.",
  },
  toPage: {
    welcome:
      "The answer to `hello` and `resume`: the robot is this page's. All of its messages carry this `epoch`, which rises each time a " +
      "page takes the robot. `at` is the relay's time, here and elsewhere: it shows how long a later message was held up.",
    command:
      "A command for the robot, which has `remaining` ms by the robot's own clock to begin, or ends as `expired`. At most 8 are " +
      "delivered at a time. With `replace` it ends all that was given before.",
    stop: "Overtakes: ends what runs and what waits in the page, then ends itself as `completed`.",
    cancel:
      "Somebody wishes that this command ends: its sender, or the owner, as `why` says. The robot decides, and says so by `ended`.",
    stored: "The ending of this command is stored: the page may forget it.",
    refused: "The ending that the page told came too late: this is how the command has ended.",
    state:
      "What becomes of a command that the page does not hold: it waits at the relay, or has ended there. Told at once where little " +
      "happens, and once a second, several in order, where much does; always before the next `command` or `stop`, and before the " +
      "`stored` of an ending that is `cancelled`.",
    drivers:
      "The robot's scripts, about once a second: who is there (`scripts`), and who was heard when (`alive`), since motions without " +
      "an end stop when their script falls silent. `paused`: the owner has paused remote driving.",
    time: "The answer to `time`: the relay's own clock.",
    yield:
      "Another page is about to take the robot: end what runs, give back what waits, begin nothing any more, tell all of " +
      "that, and say `yielded`, within a second.",
    heartbeat: "Nothing has happened for 20 s, and the line lives.",
  },
};

function closeCodes(): string {
  const lines = Object.values(closeReasons).map(
    ({ code, cause, retry }) => `- ${code}: ${cause}${retry ? "" : " (do not try again)"}`,
  );
  return ["Close codes:", ...lines].join("\n");
}
