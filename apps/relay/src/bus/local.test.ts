import { join } from "node:path";
import { onTestFinished } from "vitest";
import { SqliteStore } from "../store/sqlite/sqlite-store.ts";
import { testFolder } from "../testing/test-relay.ts";
import { LocalSwitchboard } from "./local.ts";
import { switchboardCases } from "./bus.cases.ts";

switchboardCases("LocalSwitchboard", async () => {
  const store = new SqliteStore(join(testFolder(), "corridor.sqlite"));
  onTestFinished(() => store.close());
  const relay = { store, switchboard: new LocalSwitchboard() };
  return [relay, relay];
});
