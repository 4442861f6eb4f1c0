/**
 * Messages on the robot's WebSocket, by direction. One message is one JSON text.
 *
 * Both kinds of client begin with `hello`. A page goes on with `resume`, without waiting; the relay
 * answers each of them with one `welcome`. Field names are camelCase; lengths in units, times in ms.
 */
import { z } from "zod";
import { commandRecordSchema, endingStates, idempotencyKeySchema } from "./command-record.ts";
import { commandSchema } from "./command.ts";
import { eventGapSchema, eventStreamSchema, sinceSchema, stateEventSchema } from "./events.ts";
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
/** number of a command at its robot: 1, 2, 3 */
const seq = count.min(1, { error: "1 or more" });
/** rises each time a page takes the robot; frames of an older epoch are refused */
const epoch = count.min(1, { error: "1 or more" });
const milliseconds = z.number({ error: "milliseconds" }).min(0, { error: "0 or more" });
const version = z.literal(PROTOCOL_VERSION, { error: `protocol version ${PROTOCOL_VERSION}` });

const mazeVersionError = "22 characters that tell one maze from another";
export const mazeVersionSchema = z
  .string({ error: mazeVersionError })
  .regex(/^[A-Za-z0-9_-]{22}$/, { error: mazeVersionError });

/** More endings than a page can have open; the rest of a longer list follows as `ended` messages. */
export const MAX_RESUMED_ENDINGS = 32;

/** How a command ended, as only the robot can tell. */
export const endingSchema = z.strictObject({
  seq,
  state: z.enum(endingStates, { error: `one of ${endingStates.join(", ")}` }),
  reason: z.string().max(200).nullable(),
  pose: poseSchema.nullable(),
  /** cm driven by the command */
  distance: z.number().min(0).nullable(),
});
export type Ending = z.infer<typeof endingSchema>;

/** The first message of every connection, at most 1 KiB: who speaks, and by what right. */
export const helloSchema = z.strictObject({
  type: z.literal("hello"),
  version,
  /** own: the page that is the robot; drive: a script; watch: whoever only reads */
  role: z.enum(["own", "drive", "watch"], { error: "one of own, drive, watch" }),
  key: keySchema,
  /** a script that comes back: the last state that it was told */
  since: sinceSchema.optional(),
  /** what a script calls itself, for the robot's owner */
  name: sentNameSchema.optional(),
  /** of a script: when it sent this, by the clock that its commands are timed by */
  sentAt: sentAtSchema.optional(),
});
export type Hello = z.infer<typeof helloSchema>;

/** Commands after it are numbered on from it, and no number may lose its last digit. */
const MAX_APPLIED = 281_474_976_710_656;

/** The second message of a page: what it has done so far. Nothing new is sent before it is stored. */
export const resumeSchema = z.strictObject({
  type: z.literal("resume"),
  /** highest seq that this page has started or ended; 0 when none */
  lastApplied: count.max(MAX_APPLIED, { error: "281474976710656 or less" }),
  /** true when the page was loaded anew and no longer runs what it had started */
  fresh: z.boolean(),
  /** the same on each new line of one page, and of no other: so it is known when it comes back */
  page: z
    .string()
    .regex(/^[A-Za-z0-9_-]{8,32}$/, { error: "8 to 32 of A-Z a-z 0-9 - _" })
    .optional(),
  /** endings of which the page does not know that they are stored, oldest first */
  endings: z.array(endingSchema).max(MAX_RESUMED_ENDINGS),
  /** the robot as it is now, so that who hears of these endings reads nothing older */
  snapshot: snapshotSchema.optional(),
});
export type Resume = z.infer<typeof resumeSchema>;

const heartbeat = z.strictObject({ type: z.literal("heartbeat") });

export const pageToRelaySchema = z.discriminatedUnion(
  "type",
  [
    z.strictObject({ type: z.literal("snapshot"), epoch, snapshot: snapshotSchema }),
    z.strictObject({ type: z.literal("started"), epoch, seq }),
    endingSchema.extend({ type: z.literal("ended"), epoch }),
    /** asks for the relay's time: the answer to the greeting took long, which leaves delays in doubt */
    z.strictObject({ type: z.literal("time"), epoch }),
    /** the answer to `yield`: all that this page has begun was told before, and it begins nothing any more */
    z.strictObject({ type: z.literal("yielded"), epoch }),
  ],
  { error: "one of snapshot, started, ended, time, yielded" },
);
export type PageToRelay = z.infer<typeof pageToRelaySchema>;

/** ms by the relay's own clock when it sent this: how much later another message comes shows a delay */
const at = milliseconds;

/** A command on its way to the robot. */
const deliveredCommand = z.strictObject({
  seq,
  key: idempotencyKeySchema.nullable(),
  command: commandSchema,
  acceptedAt: z.iso.datetime(),
  /** who sent it: the same for all commands of one key */
  driver: z.string().max(40),
  /** ms that it was given to start within, counted from the sender's first try */
  ttl: milliseconds,
  /** ms of them that were left when this was sent; the robot counts on by its own clock */
  remaining: milliseconds,
  /** ends what the robot was given before it as superseded */
  replace: z.boolean(),
  /** ms for which a drive goes on by itself; null where its sender asked for none */
  lease: milliseconds.nullable(),
});
export type DeliveredCommand = z.infer<typeof deliveredCommand>;

/** Scripts as the page shows them. */
export const driversSchema = z.strictObject({
  /** open sockets of scripts */
  connected: count,
  /** such as "Python"; null while none was heard */
  client: z.string().max(40).nullable(),
  /** ms since a script was last heard; null while none was */
  silentMs: count.nullable(),
});
export type Drivers = z.infer<typeof driversSchema>;

/** A script that may hold a motion: the robot goes on with `forward` only while its sender is heard. */
export const aliveDriverSchema = z.strictObject({
  /** as in `command` */
  driver: z.string().max(40),
  /** ms since it was last heard; 0 while a request of it waits for its answer */
  silentMs: milliseconds,
  /** ms since its newest line was opened; null when it never had one */
  connectionMs: milliseconds.nullable(),
});
export type AliveDriver = z.infer<typeof aliveDriverSchema>;

/**
 * Who wishes that a command ends: its sender; or the owner, who revoked its key, sent its script away or paused
 * remote driving.
 */
export const recallCauses = ["sender", "revoked", "blocked", "paused"] as const;
export type RecallCause = (typeof recallCauses)[number];

export const relayToPageSchema = z.discriminatedUnion(
  "type",
  [
    z.strictObject({ type: z.literal("welcome"), version, epoch, at }),
    deliveredCommand.extend({ type: z.literal("command"), at }),
    /** overtakes: ends what runs and what waits in the page, then ends itself as completed */
    deliveredCommand.extend({ type: z.literal("stop"), at }),
    /** somebody wishes that this command ends; the robot decides, and says so by `ended` */
    z.strictObject({ type: z.literal("cancel"), seq, cause: z.enum(recallCauses) }),
    /** the ending of this command is stored: the page may forget it */
    z.strictObject({ type: z.literal("stored"), seq }),
    /** the ending that the page told came too late: this is how the command has ended */
    z.strictObject({ type: z.literal("refused"), record: commandRecordSchema }),
    /**
     * what becomes of a command that the page does not hold: it waits, or the relay has ended it. Told within a
     * second, but before the next command or stop, and before the `stored` of an ending that is cancelled
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
      /** the owner has paused remote driving */
      paused: z.boolean(),
      at,
    }),
    /** the answer to `time` */
    z.strictObject({ type: z.literal("time"), at }),
    /** another page is about to take the robot: end what runs, give back what waits, and say `yielded` */
    z.strictObject({ type: z.literal("yield") }),
    heartbeat,
  ],
  {
    error:
      "one of welcome, command, stop, cancel, stored, refused, state, drivers, time, yield, heartbeat",
  },
);
export type RelayToPage = z.infer<typeof relayToPageSchema>;

export const driverToRelaySchema = z.discriminatedUnion(
  "type",
  [
    z.strictObject({
      type: z.literal("command"),
      /** makes a retry safe: the same key and command is never run twice */
      key: idempotencyKeySchema.optional(),
      /** when this try was sent: the time that it spends on its way counts for its time to live */
      sentAt: sentAtSchema.optional(),
      command: orderSchema,
    }),
    /** all that came up to this snapshot was read, said for each or for every second: 2 at most are on their way */
    z.strictObject({ type: z.literal("seen"), seq: count }),
  ],
  { error: "one of command, seen" },
);
export type DriverToRelay = z.infer<typeof driverToRelaySchema>;

export const relayToDriverSchema = z.discriminatedUnion(
  "type",
  [
    z.strictObject({
      type: z.literal("welcome"),
      version,
      /** with the `n` of a state, as STREAM-n, what to come back with as `since` */
      stream: eventStreamSchema,
      /** states after this one follow; null when states were missed: a `gap` follows */
      n: count.nullable(),
      /** the newest snapshot; null while the robot has not reported */
      snapshot: snapshotSchema.nullable(),
    }),
    /** the command is stored: the answer to `command` */
    z.strictObject({ type: z.literal("ack"), record: commandRecordSchema }),
    /** a command of this robot, whoever sent it, has a new state */
    stateEventSchema.extend({ type: z.literal("state") }),
    /** states before this are not kept any more: what is open now, in their place */
    eventGapSchema.extend({ type: z.literal("gap") }),
    z.strictObject({ type: z.literal("snapshot"), snapshot: snapshotSchema }),
    /** the robot is in another maze: the one that `GET .../maze` answers with this as its `ETag` */
    z.strictObject({ type: z.literal("maze"), version: mazeVersionSchema }),
    /** the message could not be served; `key` is that of the command, where it had one */
    z.strictObject({
      type: z.literal("problem"),
      problem: problemSchema,
      key: idempotencyKeySchema.nullable(),
    }),
    heartbeat,
  ],
  { error: "one of welcome, ack, state, gap, snapshot, maze, problem, heartbeat" },
);
export type RelayToDriver = z.infer<typeof relayToDriverSchema>;
