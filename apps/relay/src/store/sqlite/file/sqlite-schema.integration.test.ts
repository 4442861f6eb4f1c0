import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Command, CommandState } from "@corridor/protocol";
import { describe, expect, it, onTestFinished } from "vitest";
import { acquireStep } from "../../../commands/page-transitions.ts";
import { addStep, deliverStep, recalledStep } from "../../../commands/state-machine.ts";
import { testFolder } from "../../../testing/test-relay.ts";
import { openDatabase } from "./sqlite-schema.ts";
import { SqliteRobotStore } from "../sqlite-robot-store.ts";
import { LEFT, ID, nothingDone, sent, STOP } from "../../cases/robot-in-store.ts";

/** The last version that stored the commands of a robot together. */
const BY_ROBOT = 10;

/** The last version whose entries did not contain how a command overtakes. */
const WITHOUT_RULES = 15;

/** A file of that version with open and ended commands of two robots. */
function fileOfBefore(): string {
  const file = join(testFolder(), "corridor.sqlite");
  const db = openDatabase(file, BY_ROBOT);
  const other = "B".repeat(22);
  for (const id of [ID, other]) {
    db.prepare(
      "INSERT INTO sessions (id, epoch, last_seq, created_at, last_used_at) VALUES (?, 1, 5, 1, 1)",
    ).run(id);
    db.prepare("INSERT INTO keys (robot, hash, kind) VALUES (?, ?, 'drive')").run(id, sent.driver);
    db.prepare("INSERT INTO away (robot, id, driver, client) VALUES (?, 's', ?, 'curl')").run(
      id,
      sent.driver,
    );
  }
  const add = db.prepare(`INSERT INTO commands
      (robot, seq, driver, script, key, command, state, reason, recalled, accepted_at, ttl, deadline, lease, pose, distance, epoch)
    VALUES (?, ?, ?, 's', ?, ?, ?, ?, ?, ?, 9000, ?, 500, ?, ?, 1)`);
  const states = ["completed", "cancelled", "started", "delivered", "accepted"];
  for (const [at, state] of states.entries()) {
    const seq = at + 1;
    for (const id of [other, ID]) {
      const pose = state === "completed" ? '{"x":1,"y":2,"heading":90}' : null;
      const recalled = state === "delivered" ? "its key was revoked" : null;
      const reason = state === "cancelled" ? "a reason to be deleted" : null;
      const terms = [reason, recalled, 1_000 * seq, 1_000 * seq + 9_000, pose, pose && 100];
      add.run(id, seq, sent.driver, `a-key-${seq}`, JSON.stringify(LEFT), state, ...terms);
    }
  }
  db.close();
  return file;
}

describe("a file of an earlier Corridor", () => {
  it("retains every command unchanged, and each continues", async () => {
    const store = new SqliteRobotStore(fileOfBefore());
    onTestFinished(() => store.close());
    const all = await store.commandsAfter(ID, 0, 10);
    expect(all.map(({ seq, state }) => [seq, state])).toEqual([
      [1, "completed"],
      [2, "cancelled"],
      [3, "started"],
      [4, "delivered"],
      [5, "accepted"],
    ]);
    expect(all[0]).toEqual({
      seq: 1,
      key: "a-key-1",
      action: LEFT.action,
      command: LEFT,
      state: "completed",
      reason: null,
      acceptedAt: "1970-01-01T00:00:01.000Z",
      pose: { x: 1, y: 2, heading: 90 },
      distance: 100,
      duplicate: false,
    });
    expect((await store.openCommands(ID)).map(({ seq }) => seq)).toEqual([3, 4, 5]);
    expect(await store.commit(ID, recalledStep())).toEqual([{ seq: 4, cause: "sender" }]);
    const again = { ...sent, key: "a-key-5", command: LEFT };
    expect(await store.commit(ID, addStep(again))).toMatchObject({
      outcome: "duplicate",
      record: { seq: 5 },
    });
    expect(await store.commit(ID, deliverStep(1, 8, 6_000))).toMatchObject([
      {
        record: { seq: 5 },
        driver: sent.driver,
        script: "s",
        ttl: 9_000,
        deadline: 14_000,
        lease: 500,
      },
    ]);
    expect(await store.commit(ID, addStep(sent))).toMatchObject({
      outcome: "stored",
      record: { seq: 6 },
    });
  });

  it("deletes a robot completely, including earlier entries", async () => {
    const file = fileOfBefore();
    const store = new SqliteRobotStore(file);
    onTestFinished(() => store.close());
    for (const id of [ID, "B".repeat(22)]) await store.remove(id);
    for (const path of [file, `${file}-wal`]) {
      for (const text of ["a reason to be deleted", "a-key-"]) {
        expect(readFileSync(path).includes(text)).toBe(false);
      }
    }
  });

  it("keeps blocked scripts blocked", async () => {
    const store = new SqliteRobotStore(fileOfBefore());
    onTestFinished(() => store.close());
    expect(await store.find(ID)).toMatchObject({ blocked: [{ id: "s", client: "curl" }] });
  });

  it("is rejected by an earlier version after it was opened", () => {
    const file = fileOfBefore();
    openDatabase(file).close();
    expect(() => openDatabase(file, BY_ROBOT)).toThrow(
      /newer Corridor \(schema 19, this version supports 10\)/,
    );
  });

  it("stores the number from which a robot may have open commands", () => {
    const db = openDatabase(fileOfBefore());
    onTestFinished(() => db.close());
    expect(db.prepare("SELECT open_from FROM sessions").all()).toEqual([
      { open_from: 3 },
      { open_from: 3 },
    ]);
  });

  it("lets its stops and replacements overtake, from the tables and the journal", async () => {
    const file = join(testFolder(), "corridor.sqlite");
    const db = openDatabase(file, WITHOUT_RULES);
    db.exec(`INSERT INTO sessions (id, epoch, last_seq, created_at, last_used_at, open_from)
      VALUES ('${ID}', 1, 3, 1, 1, 1)`);
    const entryOf = (seq: number, command: Command, replaces: 0 | 1, state: CommandState) =>
      JSON.stringify(
        [
          seq,
          "d",
          null,
          null,
          JSON.stringify(command),
          5_000,
          9_000,
          14_000,
          replaces,
          null,
        ].concat([state, null, null, null, null, 1]),
      );
    const add = db.prepare("INSERT INTO commands (robot, entry) VALUES (?, ?)");
    add.run(ID, entryOf(1, LEFT, 0, "delivered"));
    add.run(ID, entryOf(2, STOP, 0, "expired"));
    add.run(ID, entryOf(3, LEFT, 0, "delivered"));
    const append = db.prepare("INSERT INTO journal (id, robot, entry) VALUES (?, ?, ?)");
    append.run(1, ID, entryOf(4, LEFT, 1, "accepted"));
    db.close();
    const store = new SqliteRobotStore(file);
    onTestFinished(() => store.close());
    await store.commit(ID, acquireStep(nothingDone));
    const all = await store.commandsAfter(ID, 0, 10);
    expect(all.map(({ seq, state }) => [seq, state])).toEqual([
      [1, "cancelled"],
      [2, "expired"],
      [3, "superseded"],
      [4, "accepted"],
    ]);
    expect((await store.openCommands(ID)).map(({ seq }) => seq)).toEqual([4]);
  });

  it("is set aside if it is damaged, instead of preventing the start", async () => {
    const file = join(testFolder(), "corridor.sqlite");
    const db = openDatabase(file, WITHOUT_RULES);
    db.exec(`INSERT INTO journal (id, robot, entry) VALUES (1, '${ID}', 'not JSON')`);
    db.close();
    const store = new SqliteRobotStore(file);
    onTestFinished(() => store.close());
    expect(existsSync(`${file}.damaged`)).toBe(true);
  });
});
