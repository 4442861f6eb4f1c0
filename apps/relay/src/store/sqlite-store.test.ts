import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { DatabaseSync } from "node:sqlite";
import { expect, it, onTestFinished } from "vitest";
import { testFolder } from "../testing/test-relay.ts";
import { SqliteStore } from "./sqlite-store.ts";
import { storeCases } from "./testing/store.cases.ts";

storeCases("SqliteStore", async () => {
  const folder = testFolder();
  const open = (): SqliteStore => {
    const store = new SqliteStore(join(folder, "deep", "corridor.sqlite"));
    // Closing twice is an error of SQLite; some cases close for themselves.
    onTestFinished(() => store.close().catch(() => undefined));
    return store;
  };
  return {
    store: open(),
    reopen: async () => open(),
    holds: async (text) =>
      readdirSync(join(folder, "deep")).some((file) =>
        readFileSync(join(folder, "deep", file)).includes(text),
      ),
  };
});

it("says so when the file was written by a newer version", () => {
  const file = join(testFolder(), "corridor.sqlite");
  const db = new DatabaseSync(file);
  db.exec("PRAGMA user_version = 99");
  db.close();
  expect(() => new SqliteStore(file)).toThrow(/newer Corridor \(schema 99/);
});
