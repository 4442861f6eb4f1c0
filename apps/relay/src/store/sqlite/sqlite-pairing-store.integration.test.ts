import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { onTestFinished } from "vitest";
import { testFolder } from "../../testing/test-relay.ts";
import { SqliteFile } from "./file/sqlite-file.ts";
import { SqlitePairingStore } from "./sqlite-pairing-store.ts";
import { SqliteRobotStore } from "./sqlite-robot-store.ts";
import { pairingStoreCases } from "../cases/pairing-store.cases.ts";

pairingStoreCases("SqlitePairingStore", async () => {
  const folder = testFolder();
  const open = () => {
    const file = new SqliteFile(join(folder, "corridor.sqlite"));
    onTestFinished(() => file.close());
    return { file, store: new SqlitePairingStore(file), robots: new SqliteRobotStore(file) };
  };
  const { file, ...stores } = open();
  return {
    ...stores,
    reopen: async () => {
      await file.close();
      return open().store;
    },
    holds: async (text) =>
      readdirSync(folder).some((file) => readFileSync(join(folder, file)).includes(text)),
  };
});
