import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it, onTestFinished } from "vitest";
import { expireStep } from "../../commands/state-machine.ts";
import { testFolder } from "../../testing/test-relay.ts";
import { SqliteDocumentStore } from "./sqlite-document-store.ts";
import { SqliteFile } from "./file/sqlite-file.ts";
import { openDatabase } from "./file/sqlite-schema.ts";
import { SqliteRobotStore } from "./sqlite-robot-store.ts";
import { documentStoreCases } from "../cases/document-store.cases.ts";

documentStoreCases("SqliteDocumentStore", async () => {
  const folder = testFolder();
  const open = (): SqliteDocumentStore => {
    const store = new SqliteDocumentStore(join(folder, "corridor.sqlite"));
    // Some cases close the store themselves.
    onTestFinished(() => store.close().catch(() => undefined));
    return store;
  };
  const store = open();
  return {
    store,
    reopen: async () => {
      await store.close();
      return open();
    },
    holds: async (text) =>
      readdirSync(folder).some((file) => readFileSync(join(folder, file)).includes(text)),
  };
});

it("migrates a file from before short links and deadlines to this schema, with its sessions", async () => {
  const path = join(testFolder(), "corridor.sqlite");
  const id = "AAAAAAAAAAAAAAAAAAAAAA";
  const db = openDatabase(path, 1);
  db.exec(`
    INSERT INTO sessions (id, created_at, last_used_at) VALUES ('${id}', 1, 1);
    INSERT INTO commands (robot, seq, driver, command, state, accepted_at)
      VALUES ('${id}', 1, 'd', '{"action":"left 90"}', 'accepted', 5000);
  `);
  db.close();

  const file = new SqliteFile(path);
  onTestFinished(() => file.close());
  const documents = new SqliteDocumentStore(file);
  const robots = new SqliteRobotStore(file);
  expect(await documents.read("AAAAAAAAAAAA", 1, 1)).toBeNull();
  expect(await robots.find(id)).toMatchObject({ id });
  expect(await robots.commit(id, expireStep(5_000))).toEqual({ ended: [], next: 15_000 });
});

it("opens a link from before short codes, and assigns a short code to the same text", async () => {
  const path = join(testFolder(), "corridor.sqlite");
  const before = 13;
  const db = openDatabase(path, before);
  db.exec(`
    INSERT INTO documents (id, hash, text, last_used_at) VALUES ('abcdefghijkl', 'h', '{}', 1);
    INSERT INTO document_keys (document, hash) VALUES ('abcdefghijkl', 'old');
  `);
  db.close();
  const store = new SqliteDocumentStore(path);
  onTestFinished(() => store.close());
  expect(await store.read("abcdefghijkl", 1, 1)).toBe("{}");
  const again = { ids: ["BCDF"], hash: "h", text: "{}", keyHash: "new", now: 2 };
  expect(await store.add(again)).toBe("BCDF");
  expect(await store.add({ ...again, keyHash: "newer", ids: ["GHJK"] })).toBe("BCDF");
  expect(await store.remove("abcdefghijkl", "old")).toBe("removed");
  expect(await store.read("BCDF", 2, 1)).toBe("{}");
});
