/** The scripts that a robot's owner has blocked, in SQLite. */
import { z } from "zod";
import type { AwayResult, ScriptChange, StoredScript, TermedRecord } from "./session-store.ts";
import type { Statements } from "./statements.ts";

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

/**
 * Blocks or unblocks a script.
 * @param blocked cancels the commands of the script
 * @returns all scripts that are blocked now
 */
export function changeAway(
  writing: Statements,
  robot: string,
  { add, remove, most }: ScriptChange,
  blocked: (script: string) => TermedRecord[],
): AwayResult {
  if (remove !== null) {
    writing.run("DELETE FROM away WHERE robot = ? AND id = ?", [robot, remove]);
  }
  const away = awayIn(writing, robot);
  if (add !== null && !away.some(({ id }) => id === add.id)) {
    if (away.length >= most) return { outcome: "full" };
    const { id, driver, name, client } = add;
    writing.run("INSERT INTO away (robot, id, driver, name, client) VALUES (?, ?, ?, ?, ?)", [
      robot,
      id,
      driver,
      name,
      client,
    ]);
  }
  const ended = add === null ? [] : blocked(add.id);
  return { outcome: "changed", away: awayIn(writing, robot), ended };
}
