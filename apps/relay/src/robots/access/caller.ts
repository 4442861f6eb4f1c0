/**
 * Callers of a robot: who they are, and what their keys permit. The relay distinguishes scripts by
 * key and name, or without a name by key and language. Scripts of one key that send neither count
 * as one.
 */
import { createHash } from "node:crypto";
import { READ_ONLY, type Hello } from "@corridor/protocol";
import { Refusal } from "../../platform/errors/problems.ts";
import type { KeyKind, StoredKey, StoredScript } from "../../store/port.ts";

/** A key in use, and the script that uses it. */
export interface Caller extends StoredKey {
  /** null for callers that are not scripts: the owner and viewers */
  script: StoredScript | null;
}

/** What a script sends about itself. */
export interface Introduction {
  /** its language, such as "Python" */
  client: string;
  /** its name; null: none */
  name: string | null;
}

export const unknownScript: Introduction = { client: "Script", name: null };

/** @returns the caller that uses a key */
export function callerOf(key: StoredKey, introduction: Introduction): Caller {
  return { ...key, script: key.kind === "drive" ? scriptOf(key.hash, introduction) : null };
}

/** @param driver hash of its key */
export function scriptOf(driver: string, { client, name }: Introduction): StoredScript {
  const mark = name === null ? `language ${client}` : `name ${name}`;
  const id = createHash("sha256").update(`${driver}\n${mark}`).digest("base64url").slice(0, 8);
  return { id, driver, client, name };
}

/** Permissions: each request and message requires one of these verbs. */
export const rights = {
  /** own the robot: receive commands and report their results */
  host: ["own"],
  /** read the stored data of the robot */
  inspect: ["own"],
  /** create, list and revoke keys */
  grant: ["own"],
  /** list scripts, block and unblock them, pause all */
  moderate: ["own"],
  /** delete the robot with all its data */
  remove: ["own"],
  /** send commands, cancel own commands, stop the robot */
  command: ["drive"],
  /** read the robot's maze */
  look: ["own", "drive", "watch"],
  /** read snapshots and states of commands */
  read: ["drive", "watch"],
  /** read the stored commands and their results */
  log: ["own", "drive", "watch"],
} as const satisfies Record<string, readonly KeyKind[]>;

export type Verb = keyof typeof rights;

/** The verb that a role in a `hello` message requires. */
export const verbOfRole = {
  own: "host",
  drive: "command",
  watch: "read",
} as const satisfies Record<Hello["role"], Verb>;

const remedies: Record<KeyKind, string> = {
  own: "The owner key is for the robot's page only. Use the driver key, the part of the address after the #.",
  drive:
    "A driver key does not permit this request. It requires the owner key, which only the robot's page has.",
  watch: READ_ONLY,
};

/**
 * Version of one robot's permissions. It rises when permissions may have changed, and once a
 * second. The result of a check stays valid while the version is unchanged, so frequent callers
 * check rarely.
 */
export class RightsVersion {
  value = 0;

  changed(): void {
    this.value += 1;
  }
}

/** @throws Refusal forbidden if keys of this kind lack the permission */
export function checkRight(kind: KeyKind, verb: Verb): void {
  const kinds: readonly KeyKind[] = rights[verb];
  if (!kinds.includes(kind)) throw new Refusal("forbidden", remedies[kind]);
}
