import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { DatabaseSync } from "node:sqlite";
import { expect, it, onTestFinished, vi } from "vitest";
import { abandonStep, acquireStep } from "../../commands/page-transitions.ts";
import {
  addStep,
  cancelStep,
  deliverStep,
  endStep,
  expireStep,
  pauseStep,
  startStep,
} from "../../commands/state-machine.ts";
import { completed } from "../../platform/testing/messages.ts";
import { testFolder } from "../../testing/test-relay.ts";
import { SqliteRobotStore } from "./sqlite-robot-store.ts";
import { storeCases } from "../cases/store.cases.ts";
import { NOW, pageState, sent, type OpenStore } from "../cases/robot-in-store.ts";

const openStore = async (): Promise<OpenStore> => {
  const folder = testFolder();
  const open = (): SqliteRobotStore => {
    const store = new SqliteRobotStore(join(folder, "deep", "corridor.sqlite"));
    onTestFinished(() => store.close());
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
      readdirSync(join(folder, "deep")).some((file) =>
        readFileSync(join(folder, "deep", file)).includes(text),
      ),
  };
};

storeCases("SqliteRobotStore", openStore);

it("finds the commands of a robot by index, for any number of ended ones", async () => {
  const file = join(testFolder(), "corridor.sqlite");
  // With a journal length of 0, the tables hold each write at the latest after the next one.
  const store = new SqliteRobotStore(file, 0);
  onTestFinished(() => store.close());
  // Starts here, because the check at startup reads everything.
  const prepare = vi.spyOn(DatabaseSync.prototype, "prepare");
  onTestFinished(() => prepare.mockRestore());
  const id = "AAAAAAAAAAAAAAAAAAAAAA";
  await store.create({ id, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
  const terms = {
    ttl: 9,
    deadline: 10,
    replace: false,
    lease: null,
    resetFrom: 0,
    maxWaiting: 64,
    keep: 100,
  };
  const command = { driver: "d", script: null, key: "a-key-0001", acceptedAt: 1, ...terms };
  await store.commit(id, addStep({ ...command, command: { action: "left 90" } }));
  await store.commit(id, addStep({ ...command, key: null, command: { action: "stop" } }));
  await store.commit(id, cancelStep(1, "d"));
  await store.commit(id, acquireStep(pageState({ lastApplied: 0, fresh: true, endings: [] })));
  await store.commit(id, deliverStep(1, 8, 2));
  await store.commit(id, startStep(1, 2));
  await store.commit(id, endStep(1, completed(2)));
  await store.commit(id, abandonStep(1));
  await store.commit(id, expireStep(2));
  // Ends a command that is in no table yet, then deletes it and the ones in the tables.
  await store.commit(id, addStep({ ...command, key: null, command: { action: "left 90" } }));
  await store.commit(id, addStep({ ...command, key: null, keep: 1, command: { action: "stop" } }));
  await store.commit(id, addStep({ ...command, key: "a-key-0002", command: { action: "stop" } }));
  await store.commit(id, acquireStep(pageState({ lastApplied: 2, fresh: true, endings: [] })));
  await store.command(id, 1);
  await store.commandsAfter(id, 0, 10);

  const statements = prepare.mock.calls.map(([sql]) => sql);
  const ofCommands = new Set(statements.filter((sql) => /\scommands\s/.test(sql)));
  const kinds = new Set([...ofCommands].map((sql) => /\w+/.exec(sql)?.[0]));
  expect(kinds).toEqual(new Set(["SELECT", "INSERT", "DELETE"]));
  const db = new DatabaseSync(file);
  onTestFinished(() => db.close());
  const slow = [...ofCommands].filter((sql) => {
    const plan = db.prepare(`EXPLAIN QUERY PLAN ${sql}`).all();
    // The deletion scans all rows older than the retained ones, which are few.
    const readsMany = sql.startsWith("DELETE")
      ? /SCAN|AUTOMATIC|by_\w+ \(robot=\?\)/
      : /SCAN (?!given)|AUTOMATIC|by_\w+ \(robot=\?\)|by_seq \(robot=\? AND seq<\?\)/;
    return plan.some(({ detail }) => readsMany.test(String(detail)));
  });
  expect(slow).toEqual([]);
});

it("reads no ended commands when it searches for open ones", async () => {
  const file = join(testFolder(), "corridor.sqlite");
  const store = new SqliteRobotStore(file, 0);
  const id = "AAAAAAAAAAAAAAAAAAAAAA";
  await store.create({ id, createdAt: 1, keys: [{ kind: "drive", hash: sent.driver }] });
  await store.commit(id, acquireStep(pageState({ lastApplied: 0, fresh: true, endings: [] })));
  for (let n = 1; n <= 5; n++) await store.commit(id, addStep(sent));
  await store.commit(id, deliverStep(1, 8, NOW));
  for (const seq of [1, 2, 3]) await store.commit(id, endStep(1, completed(seq)));
  // After the next write, the tables hold all earlier ones.
  await store.commit(id, pauseStep(false));
  await store.close();
  const db = new DatabaseSync(file);
  onTestFinished(() => db.close());
  expect(db.prepare("SELECT open_from FROM sessions").get()).toEqual({ open_from: 4 });
});

it("reports that the file was written by a newer version", () => {
  const file = join(testFolder(), "corridor.sqlite");
  const db = new DatabaseSync(file);
  db.exec("PRAGMA user_version = 99");
  db.close();
  expect(() => new SqliteRobotStore(file)).toThrow(/newer Corridor \(schema 99/);
});
