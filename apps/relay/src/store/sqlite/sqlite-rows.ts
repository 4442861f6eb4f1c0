/** Rows of commands in SQLite. */
import type { SQLInputValue } from "node:sqlite";
import type { CommandRow } from "../../commands/command-row.ts";
import { rowIn } from "./command-entry.ts";
import type { Statements } from "./file/statements.ts";

/** The column `found` of the first row; null if there is none. */
export function numberIn(
  statements: Statements,
  sql: string,
  values: SQLInputValue[] = [],
): number | null {
  const found = statements.all(sql, values)[0]?.["found"];
  return typeof found === "number" ? found : null;
}

/** The rows in the column `entry`. */
export function rowsIn(statements: Statements, sql: string, values: SQLInputValue[]): CommandRow[] {
  return statements.all(sql, values).map(({ entry }) => rowIn(String(entry)).row);
}
