import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { DatabaseSync } from "node:sqlite";
import { expect, it, onTestFinished } from "vitest";
import { testFolder } from "../testing/test-relay.ts";
import { SqliteDocumentStore } from "./sqlite-document-store.ts";
import { SqliteStore } from "./sqlite-store.ts";
import { documentStoreCases } from "./testing/document-store.cases.ts";

documentStoreCases("SqliteDocumentStore", async () => {
  const folder = testFolder();
  const open = (): SqliteDocumentStore => {
    const store = new SqliteDocumentStore(join(folder, "corridor.sqlite"));
    // Closing twice is an error of SQLite; some cases close for themselves.
    onTestFinished(() => store.close().catch(() => undefined));
    return store;
  };
  return {
    store: open(),
    reopen: async () => open(),
    holds: async (text) =>
      readdirSync(folder).some((file) => readFileSync(join(folder, file)).includes(text)),
  };
});

it("brings a file from before there were short links and deadlines to this schema, with its sessions", async () => {
  const file = join(testFolder(), "corridor.sqlite");
  const before = new SqliteStore(file);
  const id = "AAAAAAAAAAAAAAAAAAAAAA";
  await before.create({ id, createdAt: 1, keys: [] });
  await before.close();
  const db = new DatabaseSync(file);
  db.exec(`
    ALTER TABLE commands DROP COLUMN ttl;
    ALTER TABLE commands DROP COLUMN deadline;
    ALTER TABLE commands DROP COLUMN replaces;
    ALTER TABLE commands DROP COLUMN lease;
    ALTER TABLE commands DROP COLUMN recalled;
    ALTER TABLE commands DROP COLUMN script;
    DROP TABLE away;
    ALTER TABLE sessions DROP COLUMN paused;
    ALTER TABLE sessions DROP COLUMN page;
    DROP TABLE mazes;
    DROP TABLE pairings;
    ALTER TABLE keys DROP COLUMN made_at;
    ALTER TABLE keys DROP COLUMN last_used_at;
    INSERT INTO commands (robot, seq, driver, command, state, accepted_at)
      VALUES ('${id}', 1, 'd', '{"action":"left 90"}', 'accepted', 5000);
    DROP TABLE document_keys;
    DROP TABLE documents;
    PRAGMA user_version = 1;
  `);
  db.close();

  const documents = new SqliteDocumentStore(file);
  onTestFinished(() => documents.close());
  const sessions = new SqliteStore(file);
  onTestFinished(() => sessions.close());
  expect(await documents.read("AAAAAAAAAAAA", 1, 1)).toBeNull();
  expect(await sessions.find(id)).toMatchObject({ id });
  expect(await sessions.expire(id, 5_000)).toEqual({ ended: [], next: 15_000 });
});
