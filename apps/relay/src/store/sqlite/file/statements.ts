/** Statements of one SQLite connection, each prepared once. */
import type { DatabaseSync, SQLInputValue, SQLOutputValue, StatementSync } from "node:sqlite";

export type Row = Record<string, SQLOutputValue>;

/** The text in a column that is never null. */
export function textIn(row: Row, column: string): string {
  const value = row[column];
  if (typeof value !== "string") throw new Error(`the column ${column} contains no text`);
  return value;
}

export class Statements {
  readonly #db: DatabaseSync;
  readonly #prepared = new Map<string, StatementSync>();

  constructor(db: DatabaseSync) {
    this.#db = db;
  }

  all(sql: string, values: SQLInputValue[] = []): Row[] {
    return this.#statement(sql).all(...values);
  }

  /** The column `found` of the first row; null if there is none. */
  number(sql: string, values: SQLInputValue[] = []): number | null {
    const found = this.all(sql, values)[0]?.["found"];
    return typeof found === "number" ? found : null;
  }

  /** @returns the number of changed rows */
  run(sql: string, values: SQLInputValue[] = []): number {
    return Number(this.#statement(sql).run(...values).changes);
  }

  #statement(sql: string): StatementSync {
    let statement = this.#prepared.get(sql);
    if (statement === undefined) {
      statement = this.#db.prepare(sql);
      this.#prepared.set(sql, statement);
    }
    return statement;
  }
}
