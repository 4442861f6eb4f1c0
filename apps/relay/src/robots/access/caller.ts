/**
 * Identity of callers. The relay distinguishes scripts by key and name, or without a name by key
 * and language. Scripts of one key that send neither count as one.
 */
import { createHash } from "node:crypto";
import type { StoredKey, StoredScript } from "../../store/port.ts";

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
