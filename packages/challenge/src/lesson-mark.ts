/**
 * The mark of a lesson: a short hash that is equal for equal lessons, whatever file or link they
 * come from. A completion code contains it.
 */
import { sha256 } from "@noble/hashes/sha2.js";
import { bytesToHex, utf8ToBytes } from "@noble/hashes/utils.js";
import type { LessonDocument } from "./lesson-document.ts";

/** Number of hexadecimal digits of a mark: 36 bits. */
export const MARK_LENGTH = 9;

/**
 * Returns the canonical JSON of a lesson: RFC 8785 (JSON Canonicalization Scheme). There are no
 * spaces. The fields of each object are sorted by the UTF-16 code units of their names. Strings and
 * numbers are those of `JSON.stringify`, so a lone surrogate is escaped. A challenge document of
 * version 1 has the canonical JSON of its lesson (`lessonOf`).
 */
export function canonicalJson(lesson: LessonDocument): string {
  return JSON.stringify(lesson, (_, value: unknown) => (isObject(value) ? sorted(value) : value));
}

/** @returns the first 36 bits of the SHA-256 of the canonical JSON in UTF-8: 9 hexadecimal digits */
export function lessonMark(lesson: LessonDocument): string {
  return bytesToHex(sha256(utf8ToBytes(canonicalJson(lesson)))).slice(0, MARK_LENGTH);
}

function isObject(value: unknown): value is object {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function sorted(value: object): object {
  const byName = ([one]: [string, unknown], [other]: [string, unknown]) => (one < other ? -1 : 1);
  return Object.fromEntries(Object.entries(value).toSorted(byName));
}
