import { join } from "node:path";
import { onTestFinished } from "vitest";
import { SqliteRobotStore } from "../store/sqlite/sqlite-robot-store.ts";
import { testFolder } from "../testing/test-relay.ts";
import { LocalBus } from "./local.ts";
import { busCases } from "./bus.cases.ts";

busCases("LocalBus", async () => {
  const store = new SqliteRobotStore(join(testFolder(), "corridor.sqlite"));
  onTestFinished(() => store.close());
  const relay = { store, bus: new LocalBus() };
  return [relay, relay];
});
