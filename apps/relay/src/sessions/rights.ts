/** Who may do what with a robot: every call and every message asks for one of these verbs. */
import type { Hello } from "@corridor/protocol";
import { Refusal } from "../problems.ts";
import type { KeyKind } from "../store/session-store.ts";

export const rights = {
  /** be the robot: take commands, report what became of them */
  host: ["own"],
  /** see what is held of the robot */
  inspect: ["own"],
  /** make, list and revoke keys */
  grant: ["own"],
  /** see the scripts by name, send one away and let it back, pause all */
  moderate: ["own"],
  /** delete the robot with all that is held of it */
  remove: ["own"],
  /** send commands, take back its own, stop the robot */
  command: ["drive"],
  /** see the maze that the robot is in */
  look: ["own", "drive", "watch"],
  /** snapshots, and states of commands */
  read: ["drive", "watch"],
  /** the commands that are held, and what became of them */
  log: ["own", "drive", "watch"],
} as const satisfies Record<string, readonly KeyKind[]>;

export type Verb = keyof typeof rights;

/** What a key must allow for somebody to say hello in a role. */
export const verbOfRole = {
  own: "host",
  drive: "command",
  watch: "read",
} as const satisfies Record<Hello["role"], Verb>;

const remedies: Record<KeyKind, string> = {
  own: "The owner key is for the robot's page only. Use the driver key, the part of the address after the #.",
  drive:
    "A driver key does not permit this request. It requires the owner key, which only the robot's page has.",
  watch:
    "A watch key permits only reading. To send commands, ask the robot's owner for an address with a driver key.",
};

/**
 * Of one robot: rises whenever somebody's rights may have changed, and once a second. What was found by a check
 * counts for as long as it stays the same; so those who ask many times a second are looked up once in it.
 */
export class RightsVersion {
  value = 0;

  changed(): void {
    this.value += 1;
  }
}

/** @throws Refusal when keys of this kind do not allow it */
export function checkRight(kind: KeyKind, verb: Verb): void {
  const kinds: readonly KeyKind[] = rights[verb];
  if (!kinds.includes(kind)) throw new Refusal("forbidden", remedies[kind]);
}
