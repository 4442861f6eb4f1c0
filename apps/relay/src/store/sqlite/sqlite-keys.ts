/** The hashed keys of a robot in SQLite. */
import { z } from "zod";
import { keyKinds, type StoredKey } from "../../commands/robot-step.ts";
import type { KeyTimes, KeyUse } from "../robot-store.ts";
import type { Statements } from "./file/statements.ts";

const keyRow = z.object({
  hash: z.string(),
  kind: z.enum(keyKinds),
  use: z.literal("url").nullable(),
});
const timesRow = z.object({
  hash: z.string(),
  made_at: z.int(),
  last_used_at: z.int().nullable(),
});

export function keysIn(statements: Statements, robot: string): StoredKey[] {
  const rows = statements.all("SELECT hash, kind, use FROM keys WHERE robot = ?", [robot]);
  return rows.map((row) => {
    const { hash, kind, use } = keyRow.parse(row);
    return use === null ? { hash, kind } : { hash, kind, use };
  });
}

export function addKeys(
  writing: Statements,
  robot: string,
  keys: readonly StoredKey[],
  now: number,
): void {
  const sql = "INSERT INTO keys (robot, hash, kind, use, made_at) VALUES (?, ?, ?, ?, ?)";
  for (const { hash, kind, use = null } of keys) {
    writing.run(sql, [robot, hash, kind, use, now]);
  }
}

export function keyTimesIn(statements: Statements, robot: string): KeyTimes[] {
  const sql = "SELECT hash, made_at, last_used_at FROM keys WHERE robot = ?";
  return statements.all(sql, [robot]).map((row) => {
    const { made_at: createdAt, last_used_at: lastUsedAt, hash } = timesRow.parse(row);
    return { hash, createdAt, lastUsedAt };
  });
}

export function noteKeyUses(writing: Statements, robot: string, uses: readonly KeyUse[]): void {
  const sql = `UPDATE keys SET last_used_at = max(coalesce(last_used_at, 0), ?)
    WHERE robot = ? AND hash = ?`;
  for (const { hash, at } of uses) writing.run(sql, [at, robot, hash]);
}

export function removeKeys(writing: Statements, robot: string, hashes: readonly string[]): void {
  const sql = "DELETE FROM keys WHERE robot = ? AND hash = ?";
  for (const hash of hashes) writing.run(sql, [robot, hash]);
}
