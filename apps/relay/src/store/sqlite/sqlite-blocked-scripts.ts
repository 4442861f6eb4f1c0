/** The scripts that a robot's owner has blocked, in SQLite. */
import { z } from "zod";
import type { StoredScript } from "../port.ts";
import type { Statements } from "./file/statements.ts";

const awayRow = z.object({
  id: z.string(),
  driver: z.string(),
  name: z.string().nullable(),
  client: z.string(),
});

export function awayIn(statements: Statements, robot: string): StoredScript[] {
  const sql = "SELECT id, driver, name, client FROM away WHERE robot = ? ORDER BY id";
  return statements.all(sql, [robot]).map((row) => awayRow.parse(row));
}

/** @param away all scripts that are blocked now */
export function setAway(writing: Statements, robot: string, away: readonly StoredScript[]): void {
  writing.run("DELETE FROM away WHERE robot = ?", [robot]);
  const sql = "INSERT INTO away (robot, id, driver, name, client) VALUES (?, ?, ?, ?, ?)";
  for (const { id, driver, name, client } of away)
    writing.run(sql, [robot, id, driver, name, client]);
}
