import { readFileSync } from "node:fs";
import { join } from "node:path";
import { commandRecordSchema, hasEnded } from "@corridor/protocol";
import { describe, expect, it, onTestFinished } from "vitest";
import { addStep, deliverStep, recalledStep } from "../../../commands/state-machine.ts";
import { testFolder } from "../../../testing/test-relay.ts";
import { openDatabase } from "./sqlite-schema.ts";
import { SqliteRobotStore } from "../sqlite-robot-store.ts";
import { LEFT, ID, sent } from "../../cases/robot-in-store.ts";

/** The last version that stored the commands of a robot together. */
const BY_ROBOT = 10;

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
      /newer Corridor \(schema 15, this version supports 10\)/,
    );
  });

  it("treats every state as open except the final ones", () => {
    const db = openDatabase(fileOfBefore());
    onTestFinished(() => db.close());
    const isOpen = db.prepare("SELECT is_open FROM commands WHERE robot = ? AND seq = 3");
    const states = commandRecordSchema.shape.state.options.filter((state) => {
      db.prepare("UPDATE commands SET entry = json_replace(entry, '$[10]', ?)").run(state);
      return isOpen.get(ID)?.["is_open"] === (hasEnded(state) ? 0 : 1);
    });
    expect(states).toEqual(commandRecordSchema.shape.state.options);
  });

  it("stores the number from which a robot may have open commands", () => {
    const db = openDatabase(fileOfBefore());
    onTestFinished(() => db.close());
    expect(db.prepare("SELECT open_from FROM sessions").all()).toEqual([
      { open_from: 3 },
      { open_from: 3 },
    ]);
  });
});
