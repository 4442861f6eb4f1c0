/** Converts stored commands to messages for the page. */
import type { RelayToPage } from "@corridor/protocol";
import { keyId } from "../../platform/keys.ts";
import type { TermedRecord } from "../../store/port.ts";

/** The message that delivers a command, with the time left to start it. */
export function commandFrame(
  { record, driver, ttl, deadline, replace, lease }: TermedRecord,
  now: number,
): RelayToPage {
  const { seq, key, command, acceptedAt } = record;
  const type = command.action === "stop" ? "stop" : "command";
  // If the clock was set back, the command must not gain time.
  const remaining = Math.min(ttl, Math.max(0, deadline - now));
  const name = keyId(driver);
  const terms = { driver: name, ttl, remaining, replace, lease };
  return { type, at: now, seq, key, command, acceptedAt, ...terms };
}
