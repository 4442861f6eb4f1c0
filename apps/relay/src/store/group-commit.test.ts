import { join } from "node:path";
import { DatabaseSync } from "node:sqlite";
import { describe, expect, it, onTestFinished } from "vitest";
import { testFolder } from "../testing/test-relay.ts";
import { GroupCommit } from "./group-commit.ts";
import { openDatabase } from "./sqlite-schema.ts";

function withTable(now: () => number = () => 0) {
  const file = join(testFolder(), "corridor.sqlite");
  const db = openDatabase(file);
  const other = new DatabaseSync(file);
  onTestFinished(() => {
    other.close();
    db.close();
  });
  db.exec("CREATE TABLE rows (n INTEGER PRIMARY KEY, parent INTEGER REFERENCES rows (n)) STRICT");
  const commits = new GroupCommit(db, now);
  const add = (n: number) => commits.run(() => db.exec(`INSERT INTO rows (n) VALUES (${n})`));
  /** what somebody else would find after a crash at this moment */
  const kept = () => Number(other.prepare("SELECT count(*) AS n FROM rows").get()?.["n"]);
  return { db, commits, add, kept };
}

describe("commits in groups", () => {
  it("answers nobody before all of the group are on disk", async () => {
    const { add, kept } = withTable();
    const keptAtAnswer: number[] = [];
    const steps = [1, 2, 3].map((n) => add(n).then(() => keptAtAnswer.push(kept())));
    expect(kept()).toBe(0);
    await Promise.all(steps);
    expect(keptAtAnswer).toEqual([3, 3, 3]);
  });

  it("does not let a group grow beyond fifty steps", async () => {
    const { add, kept } = withTable();
    const steps = Array.from({ length: 60 }, (_, n) => add(n));
    expect(kept()).toBe(50);
    await Promise.all(steps);
    expect(kept()).toBe(60);
  });

  it("does not let a group last longer than 5 ms within one turn", async () => {
    let time = 0;
    const { add, kept } = withTable(() => (time += 2));
    const steps = [1, 2, 3].map((n) => add(n));
    expect(kept()).toBe(3);
    await Promise.all(steps);
  });

  it("undoes a step that fails, and nothing else of its group", async () => {
    const { db, commits, add, kept } = withTable();
    const failing = commits.run(() => {
      db.exec("INSERT INTO rows (n) VALUES (7)");
      throw new Error("half done");
    });
    const steps = [add(1), failing, add(1), add(2)];
    expect((await Promise.allSettled(steps)).map(({ status }) => status)).toEqual([
      "fulfilled",
      "rejected",
      "rejected",
      "fulfilled",
    ]);
    expect(kept()).toBe(2);
  });

  it("tells everyone when the commit itself fails, and goes on with the next group", async () => {
    const { db, commits, add, kept } = withTable();
    const orphan = commits.run(() =>
      db.exec("PRAGMA defer_foreign_keys = ON; INSERT INTO rows VALUES (1, 99)"),
    );
    const results = await Promise.allSettled([orphan, add(2)]);
    expect(results.map(({ status }) => status)).toEqual(["rejected", "rejected"]);
    expect(kept()).toBe(0);
    await add(3);
    expect(kept()).toBe(1);
  });

  it("commits what is open before work that wants no transaction", async () => {
    const { db, commits, add, kept } = withTable();
    const step = add(1);
    expect(commits.alone(() => [db.isTransaction, kept()])).toEqual([false, 1]);
    await step;
  });
});
