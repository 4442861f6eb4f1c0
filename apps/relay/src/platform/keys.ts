/**
 * Ids and bearer keys: random bits, 128 for robots and keys. Keys are stored only as their SHA-256.
 */
import { createHash, randomBytes, randomInt, timingSafeEqual } from "node:crypto";
import {
  CLASS_CODE_LENGTH,
  keyPrefixes,
  PAIRING_LENGTH,
  PAIRING_LETTERS,
  SHORT_CODE_LENGTHS,
} from "@corridor/protocol";

function randomText(): string {
  return randomBytes(16).toString("base64url");
}

/** Creates a robot id of 22 characters. Robot ids are not secret. */
export function mintId(): string {
  return randomText();
}

/** Number of codes to try per length before a longer code. */
const CODES_PER_LENGTH = 3;

/**
 * Candidate ids for a new short link in the order to try: random codes, shortest first. The last
 * candidate has 72 bits in 12 characters and is free even if every code is in use.
 */
export function mintLinkIds(): string[] {
  const codes = SHORT_CODE_LENGTHS.flatMap((length) =>
    Array.from({ length: CODES_PER_LENGTH }, () => letters(length)),
  );
  return [...codes, randomBytes(9).toString("base64url")];
}

/**
 * Creates a name for an event stream: 32 bits as 8 characters, enough to avoid collisions by
 * chance.
 */
export function mintStream(): string {
  return randomBytes(4).toString("hex");
}

/** Random consonants that are not confused with each other or with digits. */
function letters(count: number): string {
  const letter = (): string => PAIRING_LETTERS.charAt(randomInt(PAIRING_LETTERS.length));
  return Array.from({ length: count }, letter).join("");
}

/** Creates a key with the prefix of its kind. */
export function mintKey(kind: keyof typeof keyPrefixes): string {
  return keyPrefixes[kind] + randomText();
}

/** Creates a pairing code, one of 20^8 = 25,600,000,000. */
export function mintCode(): string {
  return letters(PAIRING_LENGTH);
}

/** Creates a code of a class, one of 20^6 = 64,000,000. */
export function mintClassCode(): string {
  return letters(CLASS_CODE_LENGTH);
}

/** Format of every key of the service: a prefix for its kind, then 128 random bits. */
const KEY_FORMAT = new RegExp(`^(?:${Object.values(keyPrefixes).join("|")})[A-Za-z0-9_-]{22}$`);

/** Whether a text has the format of a key. Other texts are rejected without a lookup. */
export function canBeKey(text: string | null): text is string {
  return text !== null && KEY_FORMAT.test(text);
}

/** Hash of a key, which the relay stores in place of the key. */
export function hashKey(key: string): string {
  return createHash("sha256").update(key).digest("base64url");
}

/** Public name of a key, derived from its hash. It distinguishes the keys of a robot. */
export function keyId(hash: string): string {
  return hash.slice(0, 6);
}

/** Id of a key for logs. It distinguishes two keys, and is too short to recover the hash. */
export function markOf(key: string | null): string | null {
  return key === null ? null : keyId(hashKey(key));
}

/** Compares two hashes in constant time. */
export function isSameHash(one: string, other: string): boolean {
  const [first, second] = [Buffer.from(one), Buffer.from(other)];
  return first.length === second.length && timingSafeEqual(first, second);
}

/** Finds the stored key that matches, in a time that does not depend on the match. */
export function matchKey<K extends { hash: string }>(key: string, stored: readonly K[]): K | null {
  const given = hashKey(key);
  let match: K | null = null;
  for (const candidate of stored) {
    if (isSameHash(candidate.hash, given)) match = candidate;
  }
  return match;
}
