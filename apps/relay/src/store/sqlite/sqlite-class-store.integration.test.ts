import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { onTestFinished } from "vitest";
import { testFolder } from "../../testing/test-relay.ts";
import { classStoreCases } from "../cases/class-store.cases.ts";
import { SqliteFile } from "./file/sqlite-file.ts";
import { SqliteClassStore } from "./sqlite-class-store.ts";

classStoreCases("SqliteClassStore", async () => {
  const folder = testFolder();
  const open = () => {
    const file = new SqliteFile(join(folder, "corridor.sqlite"));
    onTestFinished(() => file.close());
    return { file, store: new SqliteClassStore(file) };
  };
  const { file, store } = open();
  return {
    store,
    reopen: async () => {
      await file.close();
      return open().store;
    },
    holds: async (text) =>
      readdirSync(folder).some((each) => readFileSync(join(folder, each)).includes(text)),
  };
});
