/** Error responses for commands that the relay does not store. */
import { PAUSED_REASON, type CommandTerms } from "@corridor/protocol";
import { noRobot, Refusal, retryAfter } from "../../platform/errors/problems.ts";
import type { AddResult } from "../../store/port.ts";
import { keyRevoked } from "../access/key-ring.ts";
import { limits } from "../../platform/limits/limits.ts";
import { scriptIsBlocked } from "../access/script-access.ts";

/** Results of the store for a command that is neither stored nor a duplicate. */
type NotStored = Exclude<AddResult, { outcome: "stored" | "duplicate" }>;

export function notStored(result: NotStored, { ttl, age }: CommandTerms): Refusal {
  switch (result.outcome) {
    case "no-robot":
      return noRobot();
    case "revoked":
      return keyRevoked();
    case "blocked":
      return scriptIsBlocked();
    case "paused":
      return new Refusal("driving-paused", PAUSED_REASON);
    case "full":
      return new Refusal(
        "queue-full",
        `${limits.waitingCommands} commands wait at this robot, the maximum. Wait until one ends, then send this command again.`,
        { headers: retryAfter(1000) },
      );
    case "late":
      return new Refusal(
        "too-late",
        `The command is ${Math.round(age)} ms old, and its time to live (ttl) is ${ttl} ms. Check where the robot is now, then send a new command, with a longer ttl if possible.`,
      );
    case "conflict":
      return new Refusal(
        "key-conflict",
        `Command ${result.record.seq} (${result.record.action}) already uses this idempotency key. Use a new key for each command.`,
      );
  }
}

export function noCommand(seq: number): Refusal {
  return new Refusal(
    "no-command",
    `This robot has no command ${seq}. List its commands with GET .../commands.`,
  );
}

export function notYourCommand(): Refusal {
  return new Refusal(
    "forbidden",
    "Another key sent this command, and only that key can cancel it. To end all commands, send stop.",
  );
}
