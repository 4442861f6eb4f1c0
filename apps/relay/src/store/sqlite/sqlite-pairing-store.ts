/** Pairing codes in the relay's SQLite file. */
import { z } from "zod";
import type {
  NewPairing,
  PairingFinder,
  PairingStore,
  PairingTransition,
  StoredPairing,
} from "../pairing-store.ts";
import type { SqliteFile } from "./file/sqlite-file.ts";

const COLUMNS = "robot, code, ends_at, state, key, name, client";
const pairingRow = z.object({
  robot: z.string(),
  code: z.string(),
  ends_at: z.int(),
  state: z.enum(["open", "asked", "accepted", "refused"]),
  key: z.string().nullable(),
  name: z.string().nullable(),
  client: z.string().nullable(),
});

export class SqlitePairingStore implements PairingStore {
  readonly #file: SqliteFile;

  /** @param file closed by the caller */
  constructor(file: SqliteFile) {
    this.#file = file;
  }

  async open({ robot, code, endsAt }: NewPairing): Promise<"opened" | "taken" | "no-robot"> {
    const { writing } = this.#file;
    return this.#file.growingStep(() => {
      const isKnown = writing.all("SELECT 1 FROM sessions WHERE id = ?", [robot]).length > 0;
      if (!isKnown) return "no-robot";
      const others = "SELECT 1 FROM pairings WHERE code = ? AND robot <> ?";
      if (writing.all(others, [code, robot]).length > 0) return "taken";
      writing.run("DELETE FROM pairings WHERE robot = ?", [robot]);
      const sql = "INSERT INTO pairings (robot, code, ends_at, state) VALUES (?, ?, ?, 'open')";
      writing.run(sql, [robot, code, endsAt]);
      return "opened";
    });
  }

  async find(by: PairingFinder, now: number): Promise<StoredPairing | null> {
    const [column, value] = columnOf(by);
    const sql = `SELECT ${COLUMNS} FROM pairings WHERE ${column} = ? AND ends_at > ?`;
    const [found] = this.#file.reading.all(sql, [value, now]);
    if (found === undefined) return null;
    const { ends_at: endsAt, key, name, client, ...rest } = pairingRow.parse(found);
    const question = key === null ? null : { key, name, client: client ?? "" };
    return { ...rest, endsAt, question };
  }

  async transition(
    by: PairingFinder,
    { from, to, question }: PairingTransition,
    now: number,
  ): Promise<boolean> {
    const { writing } = this.#file;
    const [column, value] = columnOf(by);
    const isMeant = `${column} = ? AND state = ? AND ends_at > ?`;
    if (question === undefined) {
      const sql = `UPDATE pairings SET state = ? WHERE ${isMeant}`;
      return this.#file.step(() => writing.run(sql, [to, value, from, now]) > 0);
    }
    const { key, name, client } = question;
    const sql = `UPDATE pairings SET state = ?, key = ?, name = ?, client = ? WHERE ${isMeant}`;
    const values = [to, key, name, client, value, from, now];
    return this.#file.growingStep(() => writing.run(sql, values) > 0);
  }

  async remove(robot: string): Promise<boolean> {
    return this.#file.remove(
      () => this.#file.writing.run("DELETE FROM pairings WHERE robot = ?", [robot]) > 0,
      (removed) => removed,
    );
  }

  async removeEnded(now: number): Promise<number> {
    return this.#file.remove(
      () => this.#file.writing.run("DELETE FROM pairings WHERE ends_at <= ?", [now]),
      (count) => count > 0,
    );
  }
}

function columnOf(by: PairingFinder): [column: string, value: string] {
  const [column = "", value = ""] = Object.entries(by)[0] ?? [];
  return [column, value];
}
