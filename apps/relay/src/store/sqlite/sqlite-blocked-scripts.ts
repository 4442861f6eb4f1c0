/** The scripts that a robot's owner has blocked, in SQLite. */
import { z } from "zod";
import type { StoredScript } from "../../commands/robot-step.ts";
import type { Statements } from "./file/statements.ts";

const blockedRow = z.object({
  id: z.string(),
  driver: z.string(),
  name: z.string().nullable(),
  client: z.string(),
});

export function blockedScriptsIn(statements: Statements, robot: string): StoredScript[] {
  const sql = "SELECT id, driver, name, client FROM blocked_scripts WHERE robot = ? ORDER BY id";
  return statements.all(sql, [robot]).map((row) => blockedRow.parse(row));
}

/** @param blocked all scripts that are blocked now */
export function setBlockedScripts(
  writing: Statements,
  robot: string,
  blocked: readonly StoredScript[],
): void {
  writing.run("DELETE FROM blocked_scripts WHERE robot = ?", [robot]);
  const sql =
    "INSERT INTO blocked_scripts (robot, id, driver, name, client) VALUES (?, ?, ?, ?, ?)";
  for (const { id, driver, name, client } of blocked)
    writing.run(sql, [robot, id, driver, name, client]);
}
