/** One example of each message of a class, as it is on the wire. */
import {
  PROTOCOL_VERSION,
  type ClassHello,
  type ProgressRecord,
  type RelayToScreen,
  type RelayToStudent,
  type RelayToTeacher,
  type ScreenToRelay,
  type StudentToRelay,
  type TeacherToRelay,
  type Tile,
} from "@corridor/protocol";
import type { OfEachKind } from "./examples.ts";

export interface ClassMessageKinds {
  student: ClassHello | StudentToRelay;
  dashboard: ClassHello | TeacherToRelay;
  bigScreen: ClassHello | ScreenToRelay;
  toStudent: RelayToStudent;
  toDashboard: RelayToTeacher;
  toBigScreen: RelayToScreen;
}

const version = PROTOCOL_VERSION;
const student = 3;
const task = 2;
const code = "BCDFGH";
const lesson = "k3J9x2aBk3J9x2aBk3J9x2";
const pauseEndsInMs = 272_000;
const name = { word: 17, text: null };
const settings = { code, locked: true, pauseEndsInMs, paceTo: null, lesson };

const tile: Tile = {
  seq: 12,
  task,
  maze: "u31",
  state: "driving",
  pose: [150, 250.5, 90],
  path: "e4s2",
  line: 1,
  tick: 5678,
  bumps: 0,
  passes: null,
};

const record: ProgressRecord = {
  seq: 5,
  at: "2026-01-01T12:05:00.000Z",
  activeMs: 272_000,
  event: {
    kind: "run",
    task,
    changed: true,
    bumps: 1,
    bumpPlaces: [{ maze: "g1", column: 3, row: 1 }],
    mistakes: 1,
    failure: { code: "bump", line: 1 },
  },
};

/** summary for the big screens; its fields are the dashboard's own */
const content = { solved: 12 };

const tooFast: RelayToStudent & { type: "problem" } = {
  type: "problem",
  problem: {
    type: "/problems/too-fast",
    title: "Too many requests",
    status: 429,
    detail: "Too many messages of the type tile: at most 5 a second. Wait, then send it again.",
    errors: [],
  },
};

const badMessage: RelayToTeacher & { type: "problem" } = {
  type: "problem",
  problem: {
    type: "/problems/bad-request",
    title: "Invalid request",
    status: 400,
    detail: "Invalid message. seq: found -1, expected 0 or more.",
    errors: [{ path: "seq", found: "-1", expected: "0 or more" }],
  },
};

export const classMessageExamples: {
  [S in keyof ClassMessageKinds]: OfEachKind<ClassMessageKinds[S]>;
} = {
  student: {
    hello: { type: "hello", version, role: "learn", key: "stu_AAAAAAAAAAAAAAAAAAAAAA" },
    tile: { type: "tile", tile },
    progress: { type: "progress", seq: record.seq, event: record.event },
    program: { type: "program", seq: 9, task, link: "c1.AAAA" },
    help: { type: "help", wanted: true },
    name: { type: "name" },
  },
  dashboard: {
    hello: {
      type: "hello",
      version,
      role: "teach",
      key: "tea_AAAAAAAAAAAAAAAAAAAAAA",
      since: "k3J9x2aB-17",
    },
    watch: { type: "watch", student },
    hint: { type: "hint", student, task, hint: 2 },
    display: { type: "display", content },
    seen: { type: "seen", seq: 40 },
  },
  bigScreen: {
    hello: { type: "hello", version, role: "show", key: "scr_AAAAAAAAAAAAAAAAAAAAAA" },
    seen: { type: "seen", seq: 40 },
  },
  toStudent: {
    welcome: {
      type: "welcome",
      version,
      student,
      name,
      renamesLeft: 2,
      progress: 4,
      helpWanted: false,
      watched: false,
      pauseEndsInMs: null,
      paceTo: 1,
      lesson,
    },
    lesson: { type: "lesson", version: lesson },
    pause: { type: "pause", endsInMs: pauseEndsInMs },
    pace: { type: "pace", to: 2 },
    watched: { type: "watched", watched: true },
    hint: { type: "hint", task, hint: 2 },
    name: { type: "name", name, renamesLeft: 1 },
    stored: { type: "stored", what: "progress", seq: record.seq },
    problem: tooFast,
    heartbeat: { type: "heartbeat" },
  },
  toDashboard: {
    welcome: { type: "welcome", version, stream: "k3J9x2aB", n: 17, settings },
    tiles: { type: "tiles", seq: 40, tiles: [{ student, connected: true, tile }] },
    student: {
      type: "student",
      n: 18,
      student: {
        student,
        name,
        renamesLeft: 2,
        joinedAt: "2026-01-01T12:00:00.000Z",
        helpSince: null,
        programs: 1,
      },
      progress: record,
    },
    removed: { type: "removed", n: 19, student },
    settings: { type: "settings", n: 20, settings },
    gap: { type: "gap", n: 20 },
    displayed: { type: "displayed", priority: 1_767_225_600_000 },
    problem: badMessage,
    heartbeat: { type: "heartbeat" },
  },
  toBigScreen: {
    welcome: { type: "welcome", version, code, lesson },
    code: { type: "code", code },
    lesson: { type: "lesson", version: lesson },
    display: { type: "display", seq: 40, content },
    problem: badMessage,
    heartbeat: { type: "heartbeat" },
  },
};
