/**
 * Messages on the robot's WebSocket, by direction. Each message is one JSON text.
 *
 * All clients start with `hello`. A page sends `resume` right after it, without waiting. The relay
 * responds with one `welcome`. Field names are camelCase, lengths are in units, times in ms.
 */
import { z } from "zod";
import { commandRecordSchema, idempotencyKeySchema } from "./command-record.ts";
import { endingStates } from "./command-state.ts";
import { remoteCommandSchema, type RemoteCommand } from "./command.ts";
import { eventGapSchema, eventStreamSchema, sinceSchema, stateEventSchema } from "./events.ts";
import { marksFields } from "./marks.ts";
import { orderSchema, sentAtSchema } from "./order.ts";
import { problemSchema } from "./problem.ts";
import { poseSchema } from "./quantities.ts";
import { keySchema } from "./registration.ts";
import { MAX_SCRIPTS, MAX_BLOCKED_SCRIPTS, scriptSchema, sentNameSchema } from "./scripts.ts";
import { snapshotSchema } from "./snapshot.ts";
import { PROTOCOL_VERSION } from "./version.ts";

const count = z
  .int({ error: "a whole number" })
  .min(0, { error: "0 or more" })
  .max(Number.MAX_SAFE_INTEGER, { error: "a whole number below 2^53" });
/** number of a command of its robot: 1, 2, 3, ... */
const seq = count.min(1, { error: "1 or more" });
/** increases each time a page acquires the robot; the relay rejects messages of older epochs */
const epoch = count.min(1, { error: "1 or more" });
const milliseconds = z.number({ error: "milliseconds" }).min(0, { error: "0 or more" });
const version = z.literal(PROTOCOL_VERSION, { error: `protocol version ${PROTOCOL_VERSION}` });

const mazeVersionError = "the 22 characters of a maze version";
export const mazeVersionSchema = z
  .string({ error: mazeVersionError })
  .regex(/^[A-Za-z0-9_-]{22}$/, { error: mazeVersionError });

/** Maximum number of endings in `resume`. The page sends further ones as `ended` messages. */
export const MAX_RESUMED_ENDINGS = 32;

/** How a command ended, as the robot reports it. */
export const endingSchema = z.strictObject({
  seq,
  state: z.enum(endingStates, { error: `one of ${endingStates.join(", ")}` }),
  reason: z.string().max(200).nullable(),
  pose: poseSchema.nullable(),
  /** cm driven by the command */
  distance: z.number().min(0).nullable(),
});
export type Ending = z.infer<typeof endingSchema>;

/** The first message of every connection, at most 1 KiB: the client's role and key. */
export const helloSchema = z.strictObject({
  type: z.literal("hello"),
  version,
  /** own: the robot's page; drive: a script; watch: a viewer, who only reads */
  role: z.enum(["own", "drive", "watch"], { error: "one of own, drive, watch" }),
  key: keySchema,
  /** from a script that reconnects: the last event that it received */
  since: sinceSchema.optional(),
  /** the script's name, which the robot's owner sees */
  name: sentNameSchema.optional(),
  /** from a script: the send time by the same clock as its commands */
  sentAt: sentAtSchema.optional(),
});
export type Hello = z.infer<typeof helloSchema>;

/** 2^48. Later commands count up from `lastApplied` and must stay safe integers. */
const MAX_APPLIED = 281_474_976_710_656;

/** The second message of a page: its progress. The relay stores it before it sends new commands. */
export const resumeSchema = z.strictObject({
  type: z.literal("resume"),
  /** highest seq that this page has started or ended; 0 if none */
  lastApplied: count.max(MAX_APPLIED, { error: "281474976710656 or less" }),
  /** true if the page was reloaded, so that its started commands no longer run */
  fresh: z.boolean(),
  /**
   * identifies the page across its connections, so that the relay recognises it when it reconnects
   */
  page: z
    .string()
    .regex(/^[A-Za-z0-9_-]{8,32}$/, { error: "8 to 32 of A-Z a-z 0-9 - _" })
    .optional(),
  /** endings that the relay has not confirmed as stored, oldest first */
  endings: z.array(endingSchema).max(MAX_RESUMED_ENDINGS),
  /** the robot's current state: readers never read a snapshot older than these endings */
  snapshot: snapshotSchema.optional(),
});
export type Resume = z.infer<typeof resumeSchema>;

const marks = z.strictObject({ type: z.literal("marks"), ...marksFields });
const heartbeat = z.strictObject({ type: z.literal("heartbeat") });

export const pageToRelaySchema = z.discriminatedUnion(
  "type",
  [
    z.strictObject({ type: z.literal("snapshot"), epoch, snapshot: snapshotSchema }),
    z.strictObject({ type: z.literal("started"), epoch, seq }),
    endingSchema.extend({ type: z.literal("ended"), epoch }),
    /** requests the relay's time again: a slow `welcome` makes the estimate of delays imprecise */
    z.strictObject({ type: z.literal("time"), epoch }),
    /**
     * the response to `yield`: the page has reported all commands that it started, and starts no
     * more
     */
    z.strictObject({ type: z.literal("yielded"), epoch }),
  ],
  { error: "one of snapshot, started, ended, time, yielded" },
);
export type PageToRelay = z.infer<typeof pageToRelaySchema>;

/** send time in ms by the relay's clock, to estimate the delay of messages */
const at = milliseconds;

/** A command that the relay delivers to the robot. */
const deliveredCommand = z.strictObject({
  seq,
  key: idempotencyKeySchema.nullable(),
  command: remoteCommandSchema as z.ZodType<RemoteCommand>,
  acceptedAt: z.iso.datetime(),
  /** id of the sender's key */
  driver: z.string().max(40),
  /** time to live in ms, from the sender's first attempt */
  ttl: milliseconds,
  /** ms that were left of it at the send time; the robot counts down by its own clock */
  remaining: milliseconds,
  /** whether it ends all earlier commands as superseded */
  replace: z.boolean(),
  /** ms after which an unrenewed drive stops; null if the sender requested no lease */
  lease: milliseconds.nullable(),
});
export type DeliveredCommand = z.infer<typeof deliveredCommand>;

/** Summary of the connected scripts. */
export const driversSchema = z.strictObject({
  /** open sockets of scripts */
  connected: count,
  /** language of the latest script, such as "Python"; null before the first */
  client: z.string().max(40).nullable(),
  /** ms since the last message of a script; null before the first */
  silentMs: count.nullable(),
});
export type Drivers = z.infer<typeof driversSchema>;

/**
 * A script that may own a running motion. The robot stops `forward` when its sender goes silent.
 */
export const aliveDriverSchema = z.strictObject({
  /** as in `command` */
  driver: z.string().max(40),
  /** ms since its last message; 0 while one of its requests waits for a response */
  silentMs: milliseconds,
  /** ms since its newest connection was opened; null if it never had one */
  connectionMs: milliseconds.nullable(),
});
export type AliveDriver = z.infer<typeof aliveDriverSchema>;

/**
 * Why a command is to be cancelled: its sender requested it, or the owner revoked its key, blocked
 * its script or paused remote driving.
 */
export const recallCauses = ["sender", "revoked", "blocked", "paused"] as const;
export type RecallCause = (typeof recallCauses)[number];

export const relayToPageSchema = z.discriminatedUnion(
  "type",
  [
    z.strictObject({ type: z.literal("welcome"), version, epoch, at }),
    deliveredCommand.extend({ type: z.literal("command"), at }),
    /** bypasses the queue: ends the running and all waiting commands, then completes */
    deliveredCommand.extend({ type: z.literal("stop"), at }),
    /** requests that this command is cancelled; the robot decides, and reports by `ended` */
    z.strictObject({ type: z.literal("cancel"), seq, cause: z.enum(recallCauses) }),
    /** the ending of this command is stored: the page may discard it */
    z.strictObject({ type: z.literal("stored"), seq }),
    /** the page's `ended` arrived after the command had ended like this */
    z.strictObject({ type: z.literal("refused"), record: commandRecordSchema }),
    /**
     * a command outside of the page waits at the relay or was ended by it. Sent within a second,
     * and before the next command or stop, and before the `stored` of a cancelled ending
     */
    z.strictObject({
      type: z.literal("state"),
      record: commandRecordSchema,
      /** as in `command` */
      ttl: milliseconds,
    }),
    driversSchema.extend({
      type: z.literal("drivers"),
      alive: z.array(aliveDriverSchema).max(32),
      scripts: z.array(scriptSchema).max(MAX_SCRIPTS + MAX_BLOCKED_SCRIPTS),
      /** whether the owner has paused remote driving */
      paused: z.boolean(),
      /** whether scripts may reset the robot */
      mayReset: z.boolean(),
      at,
    }),
    /** the response to `time` */
    z.strictObject({ type: z.literal("time"), at }),
    /**
     * another page is acquiring the robot: end the running command, return waiting ones, send
     * `yielded`
     */
    z.strictObject({ type: z.literal("yield") }),
    /** a script has marked cells of the maze; fresh without cells: its marks end */
    marks,
    heartbeat,
  ],
  {
    error:
      "one of welcome, command, stop, cancel, stored, refused, state, drivers, time, yield, marks, heartbeat",
  },
);
export type RelayToPage = z.infer<typeof relayToPageSchema>;

export const driverToRelaySchema = z.discriminatedUnion(
  "type",
  [
    z.strictObject({
      type: z.literal("command"),
      /** makes retries safe: the same key and command never runs twice */
      key: idempotencyKeySchema.optional(),
      /** send time of this attempt: the relay counts its transit time towards the time to live */
      sentAt: sentAtSchema.optional(),
      command: orderSchema,
    }),
    /**
     * acknowledges all messages up to this snapshot. The relay sends at most 2 unacknowledged
     * snapshots
     */
    z.strictObject({ type: z.literal("seen"), seq: count }),
    /** marks cells of the maze, at most 10 times a second */
    marks,
  ],
  { error: "one of command, seen, marks" },
);
export type DriverToRelay = z.infer<typeof driverToRelaySchema>;

export const relayToDriverSchema = z.discriminatedUnion(
  "type",
  [
    z.strictObject({
      type: z.literal("welcome"),
      version,
      /** with the `n` of a state, as STREAM-n: the `since` of the next connection */
      stream: eventStreamSchema,
      /** states after this one follow; null if states were missed: a `gap` follows */
      n: count.nullable(),
      /** the newest snapshot; null before the robot's first report */
      snapshot: snapshotSchema.nullable(),
    }),
    /** the response to `command`: the command is stored */
    z.strictObject({ type: z.literal("ack"), record: commandRecordSchema }),
    /** a command of any script has a new state */
    stateEventSchema.extend({ type: z.literal("state") }),
    /** replaces missed states that the relay no longer retains: the commands that are open now */
    eventGapSchema.extend({ type: z.literal("gap") }),
    z.strictObject({ type: z.literal("snapshot"), snapshot: snapshotSchema }),
    /** the robot is in another maze, which `GET .../maze` returns with this as its `ETag` */
    z.strictObject({ type: z.literal("maze"), version: mazeVersionSchema }),
    /** to viewers: a script has marked cells of the maze; fresh without cells: its marks end */
    marks,
    /** the message failed; `key` is the command's key, if it had one */
    z.strictObject({
      type: z.literal("problem"),
      problem: problemSchema,
      key: idempotencyKeySchema.nullable(),
    }),
    heartbeat,
  ],
  { error: "one of welcome, ack, state, gap, snapshot, maze, marks, problem, heartbeat" },
);
export type RelayToDriver = z.infer<typeof relayToDriverSchema>;
