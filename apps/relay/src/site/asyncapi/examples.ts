/**
 * One example of each message of a robot as it is on the wire. Together they form one sequence: a
 * script moves a robot by one metre.
 */
import {
  expiredReason,
  PROTOCOL_VERSION,
  type DriverToRelay,
  type Hello,
  type Marks,
  type PageToRelay,
  type RelayToDriver,
  type RelayToPage,
  type Resume,
} from "@corridor/protocol";
import { recordExample, snapshotExample } from "../openapi/reading-aids.ts";

/** One message of each type. */
export type OfEachKind<M extends { type: string }> = { [T in M["type"]]: Extract<M, { type: T }> };

export interface MessageKinds {
  script: Hello | DriverToRelay;
  page: Hello | Resume | PageToRelay;
  toScript: RelayToDriver;
  toPage: RelayToPage;
}

const version = PROTOCOL_VERSION;
/** of the page's connection to the robot */
const epoch = 3;
const { seq, key, command, acceptedAt } = recordExample;
/** final state of the command */
const ending = {
  seq,
  state: "completed",
  reason: null,
  pose: { x: 150, y: 250, heading: 180 },
  distance: 100,
} as const;
/** ms by the relay's clock */
const at = 1_767_268_800_050;

const delivered = {
  seq,
  key,
  command,
  acceptedAt,
  driver: "Zx81qP",
  ttl: 10_000,
  remaining: 9_950,
  replace: false,
  lease: null,
  at,
};

const marks: Marks = {
  fresh: true,
  pitch: 2,
  cells: [{ column: 1, row: 31, text: "14", color: "green", walls: "esw" }],
};

export const messageExamples: { [S in keyof MessageKinds]: OfEachKind<MessageKinds[S]> } = {
  script: {
    hello: {
      type: "hello",
      version,
      role: "drive",
      key: "drv_AAAAAAAAAAAAAAAAAAAAAA",
      since: "k3J9x2aB-17",
      name: "Right wall",
      sentAt: 1_200,
    },
    command: {
      type: "command",
      key: "b1946ac92492d234",
      sentAt: 81_234,
      command: { ...command, ttl: 2_000 },
    },
    seen: { type: "seen", seq: snapshotExample.seq },
    marks: { type: "marks", ...marks },
  },
  page: {
    hello: { type: "hello", version, role: "own", key: "own_AAAAAAAAAAAAAAAAAAAAAA" },
    resume: {
      type: "resume",
      lastApplied: seq,
      fresh: false,
      page: "Zx81qPk3J9x2aB00",
      endings: [ending],
      snapshot: snapshotExample,
    },
    snapshot: { type: "snapshot", epoch, snapshot: snapshotExample },
    started: { type: "started", epoch, seq },
    ended: { type: "ended", epoch, ...ending },
    time: { type: "time", epoch },
    yielded: { type: "yielded", epoch },
  },
  toScript: {
    welcome: { type: "welcome", version, stream: "k3J9x2aB", n: 17, snapshot: snapshotExample },
    ack: { type: "ack", record: recordExample },
    state: { type: "state", n: 20, record: { ...recordExample, ...ending } },
    gap: { type: "gap", n: 1_020, open: [{ seq, state: "started" }] },
    snapshot: { type: "snapshot", snapshot: snapshotExample },
    maze: { type: "maze", version: "k3J9x2aBk3J9x2aBk3J9x2" },
    marks: { type: "marks", ...marks },
    problem: {
      type: "problem",
      problem: {
        type: "/problems/bad-request",
        title: "Invalid request",
        status: 400,
        detail: "Invalid message. command.distance: found 'far', expected a number.",
        errors: [{ path: "command.distance", found: '"far"', expected: "a number" }],
      },
      key,
    },
    heartbeat: { type: "heartbeat" },
  },
  toPage: {
    welcome: { type: "welcome", version, epoch, at },
    command: { type: "command", ...delivered },
    stop: { type: "stop", ...delivered, seq: seq + 1, key: null, command: { action: "stop" } },
    cancel: { type: "cancel", seq, cause: "sender" },
    stored: { type: "stored", seq },
    refused: {
      type: "refused",
      record: {
        ...recordExample,
        state: "cancelled",
        reason:
          "The robot disconnected. Check that its page is open and connected under Remote, then send a new command.",
      },
    },
    state: {
      type: "state",
      record: { ...recordExample, state: "expired", reason: expiredReason(10_000) },
      ttl: 10_000,
    },
    drivers: {
      type: "drivers",
      connected: 1,
      client: "Python",
      silentMs: 40,
      alive: [{ driver: "Zx81qP", silentMs: 40, connectionMs: 1_200 }],
      scripts: [
        {
          id: "k3J9x2aB",
          driver: "Zx81qP",
          name: "Right wall",
          client: "Python",
          connections: 1,
          silentMs: 40,
          last: { seq, action: "move" },
          lastProblem: null,
          isBlocked: false,
        },
      ],
      paused: false,
      mayReset: true,
      at,
    },
    time: { type: "time", at },
    yield: { type: "yield" },
    marks: { type: "marks", ...marks },
    heartbeat: { type: "heartbeat" },
  },
};
