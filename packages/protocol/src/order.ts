/**
 * A command as a script asks for it: what to do, and beside it how long the wish holds, whether it
 * takes the place of what came before, and how long a motion goes on by itself.
 *
 * `age` rises with each try of the same command, so it is no part of what is stored: a retry is the
 * same command all the same.
 */
import { z } from "zod";
import { actionNames, commandSchema, type Command } from "./command.ts";

export const TTL_MS = { least: 200, most: 60_000, default: 10_000 } as const;
export const LEASE_MS = { least: 100, most: 2_000, default: 500 } as const;
/** No client tries for longer; it keeps numbers small. */
export const MAX_AGE_MS = 3_600_000;

function milliseconds(what: string, least: number, most: number) {
  const error = `${what}, from ${least} to ${most} milliseconds`;
  return z.number({ error }).min(least, { error }).max(most, { error });
}

/**
 * ms by the sender's monotonic clock when it sent a message. Only differences count: a message that took longer
 * than the quickest one of its sender is so much older.
 */
export const sentAtSchema = milliseconds("a time by your monotonic clock", 0, 999_999_999_999_999);

const terms = {
  /** ms after the first try within which it must have started */
  ttl: milliseconds("a time to live", TTL_MS.least, TTL_MS.most).optional(),
  /** ms since the first try of this command, by the sender's own clock; 0 in the first try */
  age: milliseconds("an age", 0, MAX_AGE_MS).optional(),
  /** ends all that was sent before it as superseded, also what runs */
  replace: z.boolean({ error: "true or false" }).optional(),
};

/** ms for which the robot goes on with a drive that nothing renews */
const lease = milliseconds("a lease", LEASE_MS.least, LEASE_MS.most).optional();

const [move, turn, drive, ...plain] = commandSchema.options;

export const orderSchema = z.discriminatedUnion(
  "action",
  [
    move.extend(terms),
    turn.extend(terms),
    drive.extend({ ...terms, lease }),
    ...plain.map((command) => command.extend(terms)),
  ],
  { error: `one of ${actionNames.join(", ")}` },
);

/** What a script may send. */
export type Order = Command & {
  ttl?: number | undefined;
  age?: number | undefined;
  replace?: boolean | undefined;
  lease?: number | undefined;
};

/** An order, taken apart and complete. */
export interface CommandTerms {
  command: Command;
  ttl: number;
  age: number;
  replace: boolean;
  /** of a drive; null for everything else, and for a drive that asks for none */
  lease: number | null;
}

/** The command alone, and its terms with what holds where nothing was said. */
export function termsOf(order: Order): CommandTerms {
  const { ttl = TTL_MS.default, age = 0, replace = false, lease: asked = null, ...command } = order;
  return { command, ttl, age, replace, lease: asked };
}
