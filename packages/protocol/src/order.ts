/**
 * An order: a command together with its terms, as a script sends it. Terms are the time to live,
 * the age, whether it replaces earlier commands, and the lease of a drive.
 *
 * The relay does not store `age`, because it grows with each retry of the same command.
 */
import { z } from "zod";
import { remoteActionNames, remoteCommandSchema, type RemoteCommand } from "./command.ts";
import { LEASE_MS, TTL_MS } from "./term-bounds.ts";

/** No client retries for longer. */
export const MAX_AGE_MS = 3_600_000;

function milliseconds(what: string, min: number, max: number) {
  const error = `${what}, from ${min} to ${max} milliseconds`;
  return z.number({ error }).min(min, { error }).max(max, { error });
}

/**
 * Send time of a message in ms by the sender's monotonic clock. The relay uses only differences: it
 * adds the delay against the sender's fastest message to a command's age.
 */
export const sentAtSchema = milliseconds("a time by your monotonic clock", 0, 999_999_999_999_999);

const terms = {
  /** ms within which it must start, from the first attempt */
  ttl: milliseconds("a time to live", TTL_MS.min, TTL_MS.max).optional(),
  /** ms since the first attempt, by the sender's clock; 0 in the first attempt */
  age: milliseconds("an age", 0, MAX_AGE_MS).optional(),
  /** whether it ends all earlier commands, also the running one, as superseded */
  replace: z.boolean({ error: "true or false" }).optional(),
};

/** ms after which an unrenewed drive stops */
const lease = milliseconds("a lease", LEASE_MS.min, LEASE_MS.max).optional();

const UNGUARDED =
  "no until together with milliseconds or lease: a guarded drive ends by its conditions";

const [move, turn, drive, ...plain] = remoteCommandSchema.options;

export const orderSchema = z.discriminatedUnion(
  "action",
  [
    move.extend(terms),
    turn.extend(terms),
    drive.extend({ ...terms, lease }).check(({ value, issues }) => {
      if (value.until === undefined) return;
      if (value.milliseconds === undefined && value.lease === undefined) return;
      issues.push({ code: "custom", path: ["until"], message: UNGUARDED, input: value });
    }),
    ...plain.map((command) => command.extend(terms)),
  ],
  { error: `one of ${remoteActionNames.join(", ")}` },
);

/** A command with optional terms. */
export type Order = RemoteCommand & {
  ttl?: number | undefined;
  age?: number | undefined;
  replace?: boolean | undefined;
  lease?: number | undefined;
};

/** A command, and its terms with defaults applied. */
export interface CommandTerms {
  command: RemoteCommand;
  ttl: number;
  age: number;
  replace: boolean;
  /** of a drive; null if it requested none, and for all other actions */
  lease: number | null;
}

/** Separates a command from its terms, and applies defaults. */
export function termsOf(order: Order): CommandTerms {
  const {
    ttl = TTL_MS.default,
    age = 0,
    replace = false,
    lease: requested = null,
    ...command
  } = order;
  return { command, ttl, age, replace, lease: requested };
}
