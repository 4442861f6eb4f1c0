/**
 * Who asks, as far as a robot's owner tells scripts apart: by key and name, and where no name is given, by
 * key and language. Several scripts of one key that say nothing of themselves are one.
 */
import { createHash } from "node:crypto";
import type { StoredKey, StoredScript } from "../store/session-store.ts";

/** A key that is in use, and by which script. */
export interface Caller extends StoredKey {
  /** null for those who are no scripts: the owner, and whoever looks on */
  script: StoredScript | null;
}

/** What a script says of itself. */
export interface Introduction {
  /** its language, such as "Python" */
  client: string;
  /** what it calls itself; null: nothing */
  name: string | null;
}

export const unknownScript: Introduction = { client: "Script", name: null };

/** @returns the caller behind a key */
export function callerOf(key: StoredKey, introduction: Introduction): Caller {
  return { ...key, script: key.kind === "drive" ? scriptOf(key.hash, introduction) : null };
}

/** @param driver hash of its key */
export function scriptOf(driver: string, { client, name }: Introduction): StoredScript {
  const mark = name === null ? `language ${client}` : `name ${name}`;
  const id = createHash("sha256").update(`${driver}\n${mark}`).digest("base64url").slice(0, 8);
  return { id, driver, client, name };
}
