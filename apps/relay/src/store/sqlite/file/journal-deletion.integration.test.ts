/** Deletion of old commands, across restarts and for any state of the tables. */
import { join } from "node:path";
import { DatabaseSync } from "node:sqlite";
import { setImmediate as turn } from "node:timers/promises";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { addStep, cancelStep, deliverStep, endStep } from "../../../commands/state-machine.ts";
import { completed } from "../../../platform/testing/messages.ts";
import { testFolder } from "../../../testing/test-relay.ts";
import { LiveRobots } from "../live-robots.ts";
import { openDatabase } from "./sqlite-schema.ts";
import { SqliteRobotStore } from "../sqlite-robot-store.ts";
import { Statements } from "./statements.ts";
import { NOW, ROBOTS, sent, withRobots } from "../../cases/robot-in-store.ts";

/** The last version whose entries did not contain how a command overtakes. */
const WITHOUT_RULES = 15;

describe("the journal", () => {
  it("deletes as much across a restart: a command that ended late exists until the next command", async () => {
    const file = join(testFolder(), "corridor.sqlite");
    const [id = ""] = ROBOTS;
    for (const restarts of [false, true]) {
      let store = new SqliteRobotStore(`${file}-${restarts}`, 0);
      const maybeRestart = async (): Promise<void> => {
        if (!restarts) return;
        await store.close();
        store = new SqliteRobotStore(`${file}-${restarts}`, 0);
      };
      await withRobots(store);
      const add = (key: string) =>
        store.commit(id, addStep({ ...sent, driver: "d", keep: 2, key }));
      const seqs = async () => (await store.commandsAfter(id, 0, 10)).map(({ seq }) => seq);
      await add("key-0001");
      for (let seq = 2; seq <= 5; seq++) {
        await add(`key-000${seq}`);
        await store.commit(id, cancelStep(seq, "d"));
      }
      await maybeRestart();
      expect(await seqs()).toEqual([1, 4, 5]);
      await store.commit(id, cancelStep(1, "d"));
      expect(await store.command(id, 1)).toMatchObject({ state: "cancelled" });
      expect(await add("key-0001")).toMatchObject({ outcome: "duplicate" });
      await maybeRestart();
      expect(await seqs()).toEqual([1, 4, 5]);
      await add("key-0006");
      expect(await seqs()).toEqual([5, 6]);
      // From now on, another command has this key.
      expect(await add("key-0001")).toMatchObject({ outcome: "stored", record: { seq: 7 } });
      await store.commit(id, cancelStep(7, "d"));
      await maybeRestart();
      expect(await add("key-0001")).toMatchObject({ outcome: "duplicate", record: { seq: 7 } });
      await store.close();
    }
  });

  it("lets a key be reused immediately, although the tables still contain its command", async () => {
    vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] });
    onTestFinished(() => void vi.useRealTimers());
    const file = join(testFolder(), "corridor.sqlite");
    const store = new SqliteRobotStore(file, 4);
    await withRobots(store);
    const [id = ""] = ROBOTS;
    for (let n = 1; n <= 40; n++) {
      const command = { ...sent, driver: "d", keep: 1, key: "key-0001" };
      expect(await store.commit(id, addStep(command))).toMatchObject({
        outcome: "stored",
        record: { seq: n },
      });
      if (n % 3 === 0) {
        // Long enough for a checkpoint.
        vi.advanceTimersByTime(15);
        await turn();
      }
      await store.commit(id, deliverStep(1, 8, NOW));
      await store.commit(id, endStep(1, completed(n)));
      expect(await store.commit(id, addStep(command))).toMatchObject({ outcome: "duplicate" });
      // Deletes the previous command, because it retains only itself.
      await store.commit(id, addStep({ ...command, key: null, command: { action: "stop" } }));
      await store.commit(id, deliverStep(1, 8, NOW));
      await store.commit(id, endStep(1, completed(++n)));
    }
    const db = new DatabaseSync(file, { readOnly: true });
    onTestFinished(() => db.close());
    const entries = () => Number(db.prepare("SELECT count(*) AS n FROM journal").get()?.["n"]);
    // A checkpoint can copy all commands to the tables. Each try advances the timers.
    await vi.waitFor(() => expect(entries()).toBeLessThanOrEqual(4));
    await store.close();
  });

  it("is readable as an earlier version wrote it, whose entries did not list deleted commands", async () => {
    const folder = testFolder();
    const newer = join(folder, "newer.sqlite");
    const before = new SqliteRobotStore(newer);
    await withRobots(before);
    const [id = ""] = ROBOTS;
    for (let n = 1; n <= 3; n++)
      await before.commit(id, addStep({ ...sent, driver: "d", key: `key-000${n}` }));
    await before.commit(id, cancelStep(2, "d"));
    const records = await before.commandsAfter(id, 0, 10);
    await before.close();
    const file = join(folder, "corridor.sqlite");
    const db = openDatabase(file, WITHOUT_RULES);
    db.prepare("ATTACH ? AS newer").run(newer);
    db.exec(`
      ALTER TABLE newer.sessions DROP COLUMN may_reset;
      INSERT INTO sessions SELECT * FROM newer.sessions;
      INSERT INTO keys SELECT robot, hash, kind, made_at, last_used_at FROM newer.keys;
      INSERT INTO journal SELECT id, robot, json_remove(entry, '$[18]', '$[17]', '$[16]') FROM newer.journal;
    `);
    expect(db.prepare("SELECT json_array_length(entry) AS n FROM journal").get()).toEqual({
      n: 16,
    });
    db.close();
    const after = new SqliteRobotStore(file, 0);
    onTestFinished(() => after.close());
    expect(await after.commandsAfter(id, 0, 10)).toEqual(records);
    await after.commit(id, addStep({ ...sent, driver: "d", keep: 1 }));
    const tables = new DatabaseSync(file, { readOnly: true });
    onTestFinished(() => tables.close());
    const entries = () => tables.prepare("SELECT count(*) AS n FROM journal").get()?.["n"];
    // All commands are in the tables.
    await expect.poll(entries).toBe(0);
    expect((await after.commandsAfter(id, 0, 10)).map(({ seq }) => seq)).toEqual([1, 3, 4]);
  });

  it("deletes nothing of a robot whose deletion was rolled back", async () => {
    const file = join(testFolder(), "corridor.sqlite");
    const store = new SqliteRobotStore(file);
    await withRobots(store);
    const [id = ""] = ROBOTS;
    for (let n = 1; n <= 3; n++) await store.commit(id, addStep({ ...sent, driver: "d" }));
    await store.close();
    const db = openDatabase(file);
    onTestFinished(() => db.close());
    const live = new LiveRobots({ writing: new Statements(db), append: () => undefined }, 100);
    live.remove([id]);
    live.rolledBack();
    live.deleteOrphans();
    expect([...(live.open(id)?.commands.open ?? [])].map(({ seq }) => seq)).toEqual([1, 2, 3]);
  });

  it("deletes a robot completely if it has more entries than a statement can have parameters", async () => {
    const file = join(testFolder(), "corridor.sqlite");
    const [id = ""] = ROBOTS;
    const before = new SqliteRobotStore(file);
    await withRobots(before);
    await before.commit(id, addStep({ ...sent, driver: "d" }));
    await before.close();
    const db = new DatabaseSync(file);
    onTestFinished(() => db.close());
    const count = (): unknown => db.prepare("SELECT count(*) AS n FROM journal").get()?.["n"];
    db.exec(`WITH RECURSIVE more (id) AS (SELECT 1000 UNION ALL SELECT id + 1 FROM more WHERE id < 151000)
      INSERT INTO journal SELECT more.id, robot, entry FROM more, journal WHERE journal.id = 1`);
    expect(count()).toBeGreaterThan(150_000);
    const store = new SqliteRobotStore(file, 1_000_000);
    onTestFinished(() => store.close());
    expect(await store.remove(id)).toBe(true);
    expect(count()).toBe(0);
  });
});
