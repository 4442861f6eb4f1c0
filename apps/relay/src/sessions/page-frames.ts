/** What a page is told of a command, from what the store knows of it. */
import type { RelayToPage } from "@corridor/protocol";
import { keyId } from "../keys.ts";
import type { TermedRecord } from "../store/session-store.ts";

/** The command on its way to the robot, with the time that is left to start it. */
export function commandFrame(
  { record, driver, ttl, deadline, replace, lease }: TermedRecord,
  now: number,
): RelayToPage {
  const { seq, key, command, acceptedAt } = record;
  const type = command.action === "stop" ? "stop" : "command";
  // Where the clock was set back a little, a command has no more time than it was given.
  const remaining = Math.min(ttl, Math.max(0, deadline - now));
  const name = keyId(driver);
  const terms = { driver: name, ttl, remaining, replace, lease };
  return { type, at: now, seq, key, command, acceptedAt, ...terms };
}
