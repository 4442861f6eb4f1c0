/** Opens the storage of a relay: SQLite, or the Redis or Valkey at STORE_URL. */
import { join } from "node:path";
import type { Logger } from "pino";
import type { Clock } from "./platform/time/clock.ts";
import type { Backend } from "./backend.ts";
import { LocalBus } from "./bus/local.ts";
import { LocalClassBus } from "./bus/local-class-bus.ts";
import type { Config } from "./config.ts";
import { SqliteClassStore } from "./store/sqlite/sqlite-class-store.ts";
import { SqliteDocumentStore } from "./store/sqlite/sqlite-document-store.ts";
import { SqliteFile } from "./store/sqlite/file/sqlite-file.ts";
import { SqlitePairingStore } from "./store/sqlite/sqlite-pairing-store.ts";
import { SqliteRobotStore } from "./store/sqlite/sqlite-robot-store.ts";

/** @throws Error whose message describes the problem with the database for the operator */
export async function openBackend(
  { storeUrl, dataDir }: Pick<Config, "storeUrl" | "dataDir">,
  clock: Clock,
  log: Logger,
): Promise<Backend> {
  if (storeUrl === null) return sqliteBackend(dataDir, clock, log);
  // Loading the client of Redis takes a sixth of the relay's start.
  const { redisBackend } = await import("./redis-backend.ts");
  return redisBackend(storeUrl, clock, log);
}

function sqliteBackend(dataDir: string, clock: Clock, log: Logger): Backend {
  const file = new SqliteFile(join(dataDir, "corridor.sqlite"), {
    setAside: (to) => {
      log.error(
        { path: to },
        "the database was damaged and moved here; the relay starts with a new one",
      );
    },
  });
  return {
    clock,
    robots: new SqliteRobotStore(file),
    documents: new SqliteDocumentStore(file),
    pairings: new SqlitePairingStore(file),
    classes: new SqliteClassStore(file),
    bus: new LocalBus(),
    classBus: new LocalClassBus(),
    close: async () => file.close(),
  };
}
