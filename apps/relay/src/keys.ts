/** Ids and bearer keys: random bits, 128 for robots and keys. Keys are stored only as their SHA-256. */
import { createHash, randomBytes, randomInt, timingSafeEqual } from "node:crypto";
import { PAIRING_LENGTH, PAIRING_LETTERS, SHORT_CODE_LENGTHS } from "@corridor/protocol";
import type { KeyKind, StoredKey } from "./store/session-store.ts";

/** delete: take back what a short link leads to. line: go on with a line by HTTPS. */
const PREFIX: Record<KeyKind | "delete" | "line", string> = {
  own: "own_",
  drive: "drv_",
  watch: "wch_",
  delete: "del_",
  line: "lin_",
};

function randomText(): string {
  return randomBytes(16).toString("base64url");
}

/** A new robot id: 22 characters. It is no secret. */
export function mintId(): string {
  return randomText();
}

/** Codes of one length that are tried before a longer one. */
const CODES_PER_LENGTH = 3;

/**
 * New ids of a short link, in the order in which they are to be tried: random codes, shortest first. The last one,
 * of 72 bits as 12 characters, is free even where no code is.
 */
export function mintLinkIds(): string[] {
  const codes = SHORT_CODE_LENGTHS.flatMap((length) =>
    Array.from({ length: CODES_PER_LENGTH }, () => letters(length)),
  );
  return [...codes, randomBytes(9).toString("base64url")];
}

/** A name for a series of events: 32 bits as 8 characters, so that two are taken for one by no accident. */
export function mintStream(): string {
  return randomBytes(4).toString("hex");
}

/** Random consonants that are not mistaken for each other or for digits. */
function letters(count: number): string {
  const letter = (): string => PAIRING_LETTERS.charAt(randomInt(PAIRING_LETTERS.length));
  return Array.from({ length: count }, letter).join("");
}

/** A new key, with a prefix that names its kind. */
export function mintKey(kind: keyof typeof PREFIX): string {
  return PREFIX[kind] + randomText();
}

/** A new pairing code: one of 20 to the power of 8, 25,600,000,000. */
export function mintCode(): string {
  return letters(PAIRING_LENGTH);
}

/** Every key that the service has made: a prefix that names its kind, then 128 random bits. */
const MADE_KEY = new RegExp(`^(?:${Object.values(PREFIX).join("|")})[A-Za-z0-9_-]{22}$`);

/** Whether a text can be a key of the service. What cannot is refused before anything is looked up. */
export function canBeKey(text: string | null): text is string {
  return text !== null && MADE_KEY.test(text);
}

/** What is stored of a key. */
export function hashKey(key: string): string {
  return createHash("sha256").update(key).digest("base64url");
}

/** The name of a key that anybody may know, from its hash: enough to tell the keys of a robot apart. */
export function keyId(hash: string): string {
  return hash.slice(0, 6);
}

/** What a log may show of a key: enough to tell two apart, too little to find the hash. */
export function markOf(key: string | null): string | null {
  return key === null ? null : keyId(hashKey(key));
}

/** Whether two hashes are the same, in a time that does not depend on how alike they are. */
export function isSameHash(one: string, other: string): boolean {
  const [first, second] = [Buffer.from(one), Buffer.from(other)];
  return first.length === second.length && timingSafeEqual(first, second);
}

/** Finds the stored key that belongs to the given one, in a time that does not depend on the match. */
export function matchKey(key: string, stored: readonly StoredKey[]): StoredKey | null {
  const given = hashKey(key);
  let match: StoredKey | null = null;
  for (const candidate of stored) {
    if (isSameHash(candidate.hash, given)) match = candidate;
  }
  return match;
}
