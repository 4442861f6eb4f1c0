/** The hashed keys of a session in SQLite. */
import { z } from "zod";
import {
  keyKinds,
  type KeyChange,
  type KeysResult,
  type StoredKey,
  type TermedRecord,
} from "./session-store.ts";
import { recallAllOf } from "./sqlite-overtaking.ts";
import type { Statements } from "./statements.ts";

const keyRow = z.object({ hash: z.string(), kind: z.enum(keyKinds) });

export function keysIn(statements: Statements, robot: string): StoredKey[] {
  const rows = statements.all("SELECT hash, kind FROM keys WHERE robot = ?", [robot]);
  return rows.map((row) => keyRow.parse(row));
}

export function addKeys(writing: Statements, robot: string, keys: readonly StoredKey[]): void {
  for (const { hash, kind } of keys) {
    writing.run("INSERT INTO keys (robot, hash, kind) VALUES (?, ?, ?)", [robot, hash, kind]);
  }
}

/** Makes and revokes keys. @returns all that there are then */
export function changeKeys(
  writing: Statements,
  robot: string,
  { add, remove, removeKind, most, reason }: KeyChange,
): KeysResult {
  const isGone = ({ hash, kind }: StoredKey): boolean =>
    remove.includes(hash) || kind === removeKind;
  const all = keysIn(writing, robot);
  const kept = all.filter((key) => !isGone(key));
  if (add.length > 0 && kept.length + add.length > most) return { outcome: "full" };
  const ended: TermedRecord[] = [];
  for (const { hash } of all.filter(isGone)) {
    writing.run("DELETE FROM keys WHERE robot = ? AND hash = ?", [robot, hash]);
    writing.run("DELETE FROM away WHERE robot = ? AND driver = ?", [robot, hash]);
    ended.push(...recallAllOf(writing, robot, { driver: hash }, reason));
  }
  addKeys(writing, robot, add);
  return { outcome: "changed", keys: [...kept, ...add], ended };
}
