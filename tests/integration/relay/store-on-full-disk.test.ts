/** The store in SQLite on a real disk that is full. */
import { join } from "node:path";
import { describe, expect, it, onTestFinished } from "vitest";
import { addStep } from "../../../apps/relay/src/commands/state-machine.ts";
import { JournalWriter, type Entry } from "../../../apps/relay/src/store/sqlite/file/journal.ts";
import { openDatabase } from "../../../apps/relay/src/store/sqlite/file/sqlite-schema.ts";
import { SqliteRobotStore } from "../../../apps/relay/src/store/sqlite/sqlite-robot-store.ts";
import { smallDisk } from "../../support/test-small-disk.ts";

describe("a store on a full disk", () => {
  it("still lets owners delete if the log is long, and frees the space", async ({ skip }) => {
    const disk = smallDisk(24, skip);
    const store = new SqliteRobotStore(join(disk.folder, "corridor.sqlite"));
    onTestFinished(() => store.close());
    const ids = ["A".repeat(22), "B".repeat(22)];
    const terms = {
      ttl: 10_000,
      deadline: 10_001,
      replace: false,
      lease: null,
      resetFrom: 0,
      keep: 10_000,
    };
    for (const id of ids) {
      await store.create({ id, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
      for (let n = 0; n < 2_000; n++) {
        const key = `${"k".repeat(50)}-${n}`;
        const command = { driver: "d", script: null, key, acceptedAt: 1, maxWaiting: 10_000 };
        await store.commit(id, addStep({ ...terms, ...command, command: { action: "left 90" } }));
      }
    }
    disk.fill();
    for (const id of ids) expect(await store.remove(id)).toBe(true);
  });

  it("rejects entries of the journal as SQLite does, and continues when there is space", async ({
    skip,
  }) => {
    const disk = smallDisk(8, skip);
    const db = openDatabase(join(disk.folder, "corridor.sqlite"));
    onTestFinished(() => db.close());
    const journal = new JournalWriter(db);
    const count = (): unknown => db.prepare("SELECT count(*) AS n FROM journal").get()?.["n"];
    journal.write([[1, "robot", "entry 1"]], null);
    disk.fill();
    const much: Entry = [2, "robot", "x".repeat(1024 * 1024)];
    const nothing = { checkpoints: [], deleted: 0, unreadable: [] };
    expect(() => journal.write([much], nothing)).toThrow(expect.objectContaining({ errcode: 13 }));
    expect(count()).toBe(1);
    disk.freeSpace();
    expect(journal.write([much], null)).toBeNull();
    expect(count()).toBe(2);
  });
});
