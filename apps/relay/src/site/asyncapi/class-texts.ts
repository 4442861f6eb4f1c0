/** Texts of the AsyncAPI description about classes. They match /docs/classes. */
import type { ClassMessageKinds } from "./class-examples.ts";
import { closeCodes, type ChannelTexts } from "./texts.ts";

const STUDENT_ORDER = `1. Send \`hello\` with the role \`learn\`. The relay responds with \`welcome\`.
2. Send \`tile\` when the displayed state changes, \`progress\` and \`program\` until \`stored\` confirms them, \`help\` and \`name\`.
3. At any time, receive \`lesson\`, \`pause\`, \`pace\`, \`watched\`, \`hint\` and \`name\`.`;

const DASHBOARD_ORDER = `1. Send \`hello\` with the role \`teach\`. The relay responds with \`welcome\`, followed by the missed events or a \`gap\`.
2. At any time, receive \`tiles\`, which you acknowledge with \`seen\`, and the events \`student\`, \`removed\` and
   \`settings\`, numbered without gaps.
3. At any time, send \`watch\`, \`hint\` and \`display\`. Receive \`displayed\` when another dashboard controls the
   big screens.`;

const BIG_SCREEN_ORDER = `1. Send \`hello\` with the role \`show\`. The relay responds with \`welcome\`.
2. At any time, receive \`display\`, which you acknowledge with \`seen\`, \`code\` and \`lesson\`.`;

const HEARTBEAT = "Sent every 20 s, as evidence that the connection works.";
const REJECTED = "The message was rejected (RFC 9457).";

export const classTexts: ChannelTexts<ClassMessageKinds> = {
  channel: {
    title: "A class's WebSocket",
    summary: "Students of a class, dashboards of its teacher, and big screens.",
    description: `Order of messages for a student:

${STUDENT_ORDER}

Order of messages for a dashboard:

${DASHBOARD_ORDER}

Order of messages for a big screen:

${BIG_SCREEN_ORDER}

The role must match the key. Heartbeats and reconnection are those of a robot. A \`display\` has at most 64 KiB, and a
\`tile\` at most 1 KiB.

${closeCodes({
  forbidden: "the teacher removed the student, or the key does not permit the role",
  replaced: "another tab or device is this student now",
  over: "the class has ended, or does not exist",
  tooMany: "too many dashboards and big screens, or connections of one network",
  noRobot: null,
})}`,
  },
  operations: {
    student: {
      summary: "A student authenticates, and reports the state and the progress.",
      description: STUDENT_ORDER,
    },
    dashboard: {
      summary: "A dashboard authenticates, and directs students and big screens.",
      description: DASHBOARD_ORDER,
    },
    bigScreen: {
      summary: "A big screen authenticates, and acknowledges what it receives.",
      description: BIG_SCREEN_ORDER,
    },
    toStudent: {
      summary: "A student receives what the teacher sets.",
      description: STUDENT_ORDER,
    },
    toDashboard: {
      summary: "A dashboard receives tiles and numbered events.",
      description: DASHBOARD_ORDER,
    },
    toBigScreen: {
      summary: "A big screen receives its content, the code and the lesson.",
      description: BIG_SCREEN_ORDER,
    },
  },
  messages: {
    student: {
      hello: "The first message, which authenticates the student. `role` is `learn`.",
      tile:
        "The complete displayed state. The newest tile replaces earlier ones, and the relay stores none. At most 2 a second, and 5 while " +
        "`watched` is true.",
      progress:
        "A record of the student's work, which the relay stores once under its number: 1, 2, 3, and so on. At most 10 at once, then one in 2 s. " +
        "The relay responds with `stored`. Until then, send it again on the next connection.",
      program:
        "The newest program or drive of a task, as the text of a link. It replaces the stored one. `seq` is any number, which `stored` returns.",
      help: "The student asks for help, or does not need it any more.",
      name: "The student asks for another name, at most twice. The relay responds with `name` or `problem`.",
    },
    dashboard: {
      hello:
        "The first message, which authenticates the dashboard. `role` is `teach`. `since` is the last event that it received, STREAM-n, to resume there.",
      watch: "Receives the tiles of one student more often. The student receives `watched`.",
      hint: "Shows a hint of a task to one student.",
      display:
        "The content of the big screens, of any form. It replaces the earlier content. The relay forwards it and does not store it. At most 2 a second. With a `priority`, it does not replace content of another dashboard with a higher one, until that dashboard closes.",
      seen: "Acknowledges all `tiles` up to this number. The relay sends at most 2 unacknowledged ones.",
    },
    bigScreen: {
      hello: "The first message, which authenticates the big screen. `role` is `show`.",
      seen: "Acknowledges every `display` up to this number. The relay sends at most 2 unacknowledged ones.",
    },
    toStudent: {
      welcome:
        "The response to `hello`: the student's name and the settings. `progress` is the number of the newest stored record, and `lesson` the " +
        "`ETag` of `GET /lesson`.",
      lesson:
        "The teacher has sent another lesson. `GET /lesson` returns it with this `version` as its `ETag`.",
      pause: "A pause starts and ends by itself in `endsInMs`, or has ended (null).",
      pace: "The tasks up to this number are open; null: all.",
      watched: "A teacher starts or stops to watch this student.",
      hint: "The teacher shows this hint of the task.",
      name: "The student has another name.",
      stored: "The record or program with this number is stored. The page may discard its copy.",
      problem: REJECTED,
      heartbeat: HEARTBEAT,
    },
    toDashboard: {
      welcome:
        "The response to `hello`. Events after `n` follow. If `n` is null, events were missed, and a `gap` follows.",
      tiles:
        "Students whose tile or connection has changed, at most 2 batches a second, or 5 while the dashboard watches a student. The first batch contains all students.",
      student:
        "A student joined or changed. `progress` is a new record, or null. `n` increases by one with each event.",
      removed: "A student was removed.",
      settings: "The code, lock, pause, pace or lesson has changed.",
      gap: "Replaces events that are no longer stored. Read the class with `GET /classes/ID`.",
      displayed:
        "The `priority` of what the big screens show now, after another dashboard has replaced it. Null: its dashboard has closed, and any content replaces it.",
      problem: REJECTED,
      heartbeat: HEARTBEAT,
    },
    toBigScreen: {
      welcome: "The response to `hello`: the code of the class, and the `ETag` of its lesson.",
      code: "The class has another code.",
      lesson:
        "The teacher has sent another lesson. `GET /lesson` returns it with this `version` as its `ETag`.",
      display: "The newest content from a dashboard. Newer content replaces unsent content.",
      problem: REJECTED,
      heartbeat: HEARTBEAT,
    },
  },
};
