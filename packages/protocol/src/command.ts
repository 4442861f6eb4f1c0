/** The commands that any driver (Me, Program, Remote) may send to the robot. */
import { z } from "zod";
import { untilSchema, type UntilCondition } from "./condition.ts";

/** Actions without parameters. Programs may use all of them. */
export const plainActions = [
  "forward",
  "reverse",
  "stop",
  "left 90",
  "right 90",
  "turn 180",
  "delayed left 90",
  "delayed right 90",
] as const;
export type PlainAction = (typeof plainActions)[number];

export const actionNames = [...plainActions, "move", "turn", "drive"] as const;
/** The actions that a script may send: those of all drivers, and `reset`. */
export const remoteActionNames = [...actionNames, "reset"] as const;

/** The action of a record, an open list: readers accept actions that they do not know. */
export const recordActionSchema = z
  .string()
  .max(40)
  .meta({
    description: "An open list: clients must accept actions that they do not know.",
    examples: [...remoteActionNames],
  });

const MAX_MOVE = 25_600;
const MAX_TURN = 3_600;
const MAX_DRIVE_MS = 60_000;

const wheelPower = z
  .number({ error: "a wheel power from -1 to 1" })
  .min(-1, { error: "a wheel power from -1 to 1" })
  .max(1, { error: "a wheel power from -1 to 1" });

function within(limit: number, what: string) {
  const error = `${what} from ${-limit} to ${limit}`;
  return z.number({ error }).min(-limit, { error }).max(limit, { error });
}

const plainCommands = plainActions.map((action) => z.strictObject({ action: z.literal(action) }));

/**
 * One command. `move` in units (negative: backward), `turn` in degrees (negative: left), `drive` in
 * wheel powers from -1 to 1, for `milliseconds` or until the next command.
 */
export const commandSchema = z.discriminatedUnion(
  "action",
  [
    z.strictObject({
      action: z.literal("move"),
      distance: within(MAX_MOVE, "a distance in cm"),
    }),
    z.strictObject({ action: z.literal("turn"), degrees: within(MAX_TURN, "an angle in degrees") }),
    z.strictObject({
      action: z.literal("drive"),
      left: wheelPower,
      right: wheelPower,
      milliseconds: z
        .number({ error: `a time from 1 to ${MAX_DRIVE_MS} milliseconds` })
        .min(1, { error: `a time from 1 to ${MAX_DRIVE_MS} milliseconds` })
        .max(MAX_DRIVE_MS, { error: `a time from 1 to ${MAX_DRIVE_MS} milliseconds` })
        .optional(),
    }),
    ...plainCommands,
  ],
  { error: `one of ${actionNames.join(", ")}` },
);

export type Command =
  | { action: PlainAction }
  | { action: "move"; distance: number }
  | { action: "turn"; degrees: number }
  | { action: "drive"; left: number; right: number; milliseconds?: number | undefined };

const [move, turn, drive, ...plain] = commandSchema.options;

/** Actions without fields that conditions can end. */
const guardedActions: readonly string[] = ["forward", "reverse"];
const until = untilSchema.optional();

/**
 * A command of a script. Unlike other drivers, a script may guard a motion, and may `reset` the
 * robot: it ends all earlier commands and starts a new run. Programs, recorded runs and links contain
 * neither `until` nor `reset`.
 */
export const remoteCommandSchema = z.discriminatedUnion(
  "action",
  [
    move,
    turn,
    drive.extend({ until }),
    ...plain.map((each) =>
      guardedActions.includes(each.shape.action.value) ? each.extend({ until }) : each,
    ),
    z.strictObject({ action: z.literal("reset") }),
  ],
  { error: `one of ${remoteActionNames.join(", ")}` },
);

export type RemoteCommand = (Command | { action: "reset" }) & {
  until?: UntilCondition[] | undefined;
};

/**
 * Whether it is a velocity, of which only the newest value counts: a drive without an end. Only the
 * next velocity renews its lease.
 */
export function isVelocity(command: RemoteCommand): boolean {
  const isEndless = command.action === "drive" && command.milliseconds === undefined;
  return isEndless && command.until === undefined;
}

/** A command with an action that this version does not know. */
export const otherCommandSchema = z.looseObject({ action: recordActionSchema });

/** The command of a record. Its type lists the known actions; readers also accept others. */
export const recordedCommandSchema = z.union([
  remoteCommandSchema,
  otherCommandSchema,
]) as z.ZodType as z.ZodType<RemoteCommand>;
