import { join } from "node:path";
import { DatabaseSync } from "node:sqlite";
import fc from "fast-check";
import { describe, expect, it, onTestFinished } from "vitest";
import { testFolder } from "../../../testing/test-relay.ts";
import { GroupCommit } from "./group-commit.ts";
import { openDatabase } from "./sqlite-schema.ts";

function withTable(now: () => number = () => 0) {
  const file = join(testFolder(), "corridor.sqlite");
  const db = openDatabase(file);
  const other = new DatabaseSync(file);
  db.exec("CREATE TABLE rows (n INTEGER PRIMARY KEY, parent INTEGER REFERENCES rows (n)) STRICT");
  const commits = new GroupCommit(db, { now });
  onTestFinished(() => {
    commits.close();
    other.close();
    db.close();
  });
  const add = (n: number) => commits.run(() => db.exec(`INSERT INTO rows (n) VALUES (${n})`));
  /** what another process would find after a crash at this point */
  const stored = () => Number(other.prepare("SELECT count(*) AS n FROM rows").get()?.["n"]);
  return { db, commits, add, stored };
}

describe("commits in groups", () => {
  it("answers no step before the whole group is on disk", async () => {
    const { add, stored } = withTable();
    const storedAtAnswer: number[] = [];
    const steps = [1, 2, 3].map((n) => add(n).then(() => storedAtAnswer.push(stored())));
    expect(stored()).toBe(0);
    await Promise.all(steps);
    expect(storedAtAnswer).toEqual([3, 3, 3]);
  });

  it("does not let a group grow beyond 50 steps", async () => {
    const { add, stored } = withTable();
    const steps = Array.from({ length: 120 }, (_, n) => add(n));
    expect(stored()).toBe(100);
    await Promise.all(steps);
    expect(stored()).toBe(120);
  });

  it("does not let a group last longer than 5 ms within one turn", async () => {
    let time = 0;
    const { add, stored } = withTable(() => (time += 2));
    const steps = [1, 2, 3].map((n) => add(n));
    expect(stored()).toBe(3);
    await Promise.all(steps);
  });

  it("rolls back a failed step, and no other of its group", async () => {
    const { db, commits, add, stored } = withTable();
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
    expect(stored()).toBe(2);
  });

  it("rejects all steps when the commit itself fails, and continues with the next group", async () => {
    const { db, commits, add, stored } = withTable();
    const orphan = commits.run(() =>
      db.exec("PRAGMA defer_foreign_keys = ON; INSERT INTO rows VALUES (1, 99)"),
    );
    const results = await Promise.allSettled([orphan, add(2)]);
    expect(results.map(({ status }) => status)).toEqual(["rejected", "rejected"]);
    expect(stored()).toBe(0);
    await add(3);
    expect(stored()).toBe(1);
  });

  it("commits open steps before work without a transaction", async () => {
    const { db, commits, add, stored } = withTable();
    const step = add(1);
    expect(await commits.alone(() => [db.isTransaction, stored()])).toEqual([false, 1]);
    await step;
  });

  it("has the same result as the steps one by one, whichever of them fail midway", async () => {
    /**
     * adds rows one by one; a duplicate row throws, and `throws` makes the step throw at its end
     */
    const steps = fc.array(
      fc.record({
        rows: fc.array(fc.integer({ min: 0, max: 12 }), { maxLength: 3 }),
        throws: fc.boolean(),
      }),
      { maxLength: 20 },
    );
    const { db, commits } = withTable();
    const insert = db.prepare("INSERT INTO rows (n) VALUES (?)");
    const rows = () =>
      db
        .prepare("SELECT n FROM rows ORDER BY n")
        .all()
        .map(({ n }) => Number(n));
    await fc.assert(
      fc.asyncProperty(steps, async (all) => {
        const outcomes = await Promise.allSettled(
          all.map((each) =>
            commits.run(() => {
              for (const n of each.rows) insert.run(n);
              if (each.throws) throw new Error("half done");
              return rows().length;
            }),
          ),
        );
        const stored = new Set<number>();
        const expected = all.map((each) => {
          const isNew = new Set([...stored, ...each.rows]).size === stored.size + each.rows.length;
          if (each.throws || !isNew) return "threw";
          for (const n of each.rows) stored.add(n);
          return stored.size;
        });
        expect(
          outcomes.map((each) => (each.status === "fulfilled" ? each.value : "threw")),
        ).toEqual(expected);
        expect(rows()).toEqual([...stored].toSorted((a, b) => a - b));
        db.exec("DELETE FROM rows");
      }),
    );
  });

  it("rejects all steps if those before a failed one cannot be repeated", async () => {
    const { db, commits, add, stored } = withTable();
    let isFirst = true;
    const once = commits.run(() => {
      if (!isFirst) throw new Error("not again");
      isFirst = false;
      db.exec("INSERT INTO rows (n) VALUES (5)");
    });
    const other = add(6);
    const failing = commits.run(() => {
      throw new Error("half done");
    });
    const results = await Promise.allSettled([once, other, failing]);
    expect(results.map((each) => each.status === "rejected" && String(each.reason))).toEqual([
      "Error: not again",
      "Error: not again",
      "Error: half done",
    ]);
    expect(stored()).toBe(0);
    await add(7);
    expect(stored()).toBe(1);
  });
});
