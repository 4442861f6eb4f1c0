/** A store returns the same results for any journal length and any interruption. */
import { readdirSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { DatabaseSync } from "node:sqlite";
import { setImmediate as turn } from "node:timers/promises";
import fc from "fast-check";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { addStep, deliverStep, endStep, startStep } from "../../../commands/state-machine.ts";
import { completed } from "../../../platform/testing/messages.ts";
import { testFolder } from "../../../testing/test-relay.ts";
import type { RobotStore } from "../../robot-store.ts";
import { SqliteRobotStore } from "../sqlite-robot-store.ts";
import { NOW, ROBOTS, sent, withRobots } from "../../cases/robot-in-store.ts";
import { stepsKeeping, contentsOf, type StepOfRobot } from "../../cases/random-steps.ts";

/** A step, its robot, and an event in the store after it. */
interface Turn extends StepOfRobot {
  after: "nothing" | "restart" | "rolled back" | "idle";
}

const turns = fc.array(
  fc.record<Turn>({
    step: stepsKeeping(2, 100),
    robot: fc.constantFrom(...ROBOTS),
    after: fc.constantFrom(
      "nothing",
      "nothing",
      "nothing",
      "nothing",
      "restart",
      "rolled back",
      "idle",
    ),
  }),
  { minLength: 10, maxLength: 60 },
);

/** A step that fails, so that its group is rolled back and runs again. */
const failing = async (store: RobotStore, id = ROBOTS[0] ?? ""): Promise<void> => {
  const again = store.create({ id, createdAt: 1, keys: [] });
  await expect(again).rejects.toThrow(/UNIQUE/);
};

describe("the journal", () => {
  it("loses and changes nothing at any length, across restarts and rolled-back steps", async () => {
    vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] });
    onTestFinished(() => void vi.useRealTimers());
    const folder = testFolder();
    let runs = 0;
    await fc.assert(
      fc.asyncProperty(
        turns,
        fc.constantFrom(0, 1, 3, 8, 30),
        fc.boolean(),
        async (all, long, isHurried) => {
          const file = join(folder, `${runs++}.sqlite`);
          const open = () => new SqliteRobotStore(file, long);
          const plain = new SqliteRobotStore(`${file}-plain`, 1_000_000);
          let store = open();
          await Promise.all([withRobots(plain), withRobots(store)]);
          let asked: Promise<unknown>[] = [];
          const answered = async (): Promise<void> => {
            for (const each of asked) await each;
            asked = [];
          };
          for (const { step, robot, after } of all) {
            const pair = [step(store, robot), step(plain, robot)];
            asked.push(Promise.all(pair).then(([got, expected]) => expect(got).toEqual(expected)));
            if (after === "rolled back") asked.push(failing(store));
            if (after === "nothing" && isHurried) continue;
            await answered();
            if (after === "idle") {
              // Long enough for a checkpoint.
              vi.advanceTimersByTime(15);
              await turn();
            }
            if (after !== "restart") continue;
            await store.close();
            store = open();
          }
          await answered();
          expect(await contentsOf(store)).toEqual(await contentsOf(plain));
          await Promise.all([store.close(), plain.close()]);
        },
      ),
      { numRuns: 25 },
    );
  });

  it("keeps serving other robots when one record is corrupt, and is deleted with that robot", async () => {
    const file = join(testFolder(), "corridor.sqlite");
    const before = new SqliteRobotStore(file);
    await withRobots(before);
    for (const id of ROBOTS) await before.commit(id, addStep({ ...sent, driver: "d" }));
    await before.close();
    const [bad = "", good = ""] = ROBOTS;
    const db = new DatabaseSync(file);
    db.exec(`UPDATE journal SET entry = '[]' WHERE robot = '${bad}'`);
    db.close();
    const store = new SqliteRobotStore(file);
    onTestFinished(() => store.close());
    await expect(store.commit(bad, addStep({ ...sent, driver: "d" }))).rejects.toThrow(/JSON/);
    expect(await store.commit(good, addStep({ ...sent, driver: "d" }))).toMatchObject({
      record: { seq: 2 },
    });
    expect(await store.remove(bad)).toBe(true);
    await failing(store, good);
    expect(await store.commit(bad, addStep({ ...sent, driver: "d" }))).toEqual({
      outcome: "no-robot",
    });
    expect((await store.openCommands(good)).length).toBe(2);
  });

  it("retains unreadable entries of one robot, however many of other robots are compacted", async () => {
    const file = join(testFolder(), "corridor.sqlite");
    const before = new SqliteRobotStore(file);
    await withRobots(before);
    const [bad = "", good = ""] = ROBOTS;
    for (let n = 0; n < 5; n++) await before.commit(bad, addStep({ ...sent, driver: "d" }));
    await before.close();
    const db = new DatabaseSync(file);
    onTestFinished(() => db.close());
    const newest = `(SELECT max(id) FROM journal WHERE robot = '${bad}')`;
    const whole = String(
      db.prepare(`SELECT entry FROM journal WHERE id = ${newest}`).get()?.["entry"],
    );
    db.exec(`UPDATE journal SET entry = '[]' WHERE id = ${newest}`);
    const store = new SqliteRobotStore(file, 2);
    for (let n = 1; n <= 20; n++) {
      await store.commit(good, addStep({ ...sent, driver: "d" }));
      await store.commit(good, deliverStep(1, 8, NOW));
      await store.commit(good, endStep(1, completed(n)));
    }
    await store.close();
    expect(db.prepare("SELECT count(*) AS n FROM commands").get()?.["n"]).toBeGreaterThan(0);
    // Repairs the entry by hand.
    db.prepare(`UPDATE journal SET entry = ? WHERE id = ${newest}`).run(whole);
    const after = new SqliteRobotStore(file, 2);
    onTestFinished(() => after.close());
    expect((await after.commandsAfter(bad, 0, 10)).map(({ seq }) => seq)).toEqual([1, 2, 3, 4, 5]);
    expect(await after.commit(bad, addStep({ ...sent, driver: "d" }))).toMatchObject({
      record: { seq: 6 },
    });
  });

  it("contains nothing of a deleted robot of any size, even if the deletion was interrupted", async () => {
    const folder = testFolder();
    const file = join(folder, "corridor.sqlite");
    const holds = (text: string): boolean =>
      readdirSync(folder).some((name) => readFileSync(join(folder, name)).includes(text));
    const fill = async (store: RobotStore, id: string): Promise<void> => {
      for (let n = 0; n < 1_300; n++) {
        const key = `traces-of-${id}-${n}`;
        await store.commit(
          id,
          addStep({ ...sent, driver: "d", key, keep: 10_000, maxWaiting: 10_000 }),
        );
      }
    };
    const [first = "", second = "", third = ""] = ROBOTS;
    const before = new SqliteRobotStore(file);
    await withRobots(before);
    await fill(before, first);
    await fill(before, second);
    expect(holds(`traces-of-${first}`)).toBe(true);
    await before.remove(first);
    expect(holds(`traces-of-${first}`)).toBe(false);
    await before.close();
    // The state after a relay was killed during a deletion.
    const db = new DatabaseSync(file);
    db.exec("PRAGMA foreign_keys = ON");
    db.prepare("DELETE FROM sessions WHERE id = ?").run(second);
    db.close();
    const after = new SqliteRobotStore(file);
    onTestFinished(() => after.close());
    await expect.poll(() => holds(`traces-of-${second}`)).toBe(false);
    expect(await after.commit(third, addStep({ ...sent, driver: "d" }))).toMatchObject({
      outcome: "stored",
    });
  });

  it("is compacted in small parts: no step writes much, at any length of the journal", async () => {
    const file = join(testFolder(), "corridor.sqlite");
    const store = new SqliteRobotStore(file, 3_000);
    onTestFinished(() => store.close());
    await withRobots(store);
    // The log restarts occasionally. Its growth is the amount written.
    const size = (): number => statSync(`${file}-wal`).size;
    let most = 0;
    for (let n = 1; n <= 1_200; n++) {
      const id = ROBOTS[n % 2] ?? "";
      const before = size();
      const { record } = (await store.commit(
        id,
        addStep({ ...sent, driver: "d", keep: 10_000 }),
      )) as {
        record: { seq: number };
      };
      await store.commit(id, deliverStep(1, 8, NOW));
      await store.commit(id, startStep(1, record.seq));
      await store.commit(id, endStep(1, completed(record.seq)));
      most = Math.max(most, size() - before);
    }
    expect(most).toBeGreaterThan(0);
    expect(most).toBeLessThan(1_000_000);
  });

  it("holds back at most a few hundred ended commands of a robot from the tables", async () => {
    const file = join(testFolder(), "corridor.sqlite");
    const store = new SqliteRobotStore(file);
    onTestFinished(() => store.close());
    await withRobots(store);
    const [id = ""] = ROBOTS;
    for (let n = 1; n <= 600; n++) {
      await Promise.all([
        store.commit(id, addStep({ ...sent, driver: "d", keep: 10_000 })),
        store.commit(id, deliverStep(1, 8, NOW)),
        store.commit(id, endStep(1, completed(n))),
      ]);
    }
    const db = new DatabaseSync(file, { readOnly: true });
    onTestFinished(() => db.close());
    const inTable = Number(db.prepare("SELECT count(*) AS n FROM commands").get()?.["n"]);
    expect(inTable).toBeGreaterThan(300);
    const all = await store.commandsAfter(id, 0, 1_000);
    expect(all.map(({ seq }) => seq)).toEqual(Array.from({ length: 600 }, (_, n) => n + 1));
  });

  it("stays below its maximum length, and deletes a robot completely", async () => {
    const file = join(testFolder(), "corridor.sqlite");
    const store = new SqliteRobotStore(file, 64);
    onTestFinished(() => store.close());
    await withRobots(store);
    const db = new DatabaseSync(file, { readOnly: true });
    onTestFinished(() => db.close());
    const entries = (where = ""): number =>
      Number(db.prepare(`SELECT count(*) AS n FROM journal ${where}`).get()?.["n"]);
    // The store is never idle meanwhile, so compaction runs only when it is overdue.
    let longest = 0;
    for (let n = 1; n <= 100; n++) {
      await Promise.all(
        ROBOTS.flatMap((id) => [
          store.commit(id, addStep({ ...sent, driver: "d" })),
          store.commit(id, deliverStep(1, 8, NOW)),
          store.commit(id, endStep(1, completed(n))),
        ]),
      );
      longest = Math.max(longest, entries());
    }
    expect(longest).toBeGreaterThan(3 * 64);
    expect(longest).toBeLessThan(5 * 64);
    await expect.poll(() => entries()).toBeLessThanOrEqual(64);
    const [gone = ""] = ROBOTS;
    await store.commit(gone, addStep({ ...sent, driver: "d" }));
    expect(entries(`WHERE robot = '${gone}'`)).toBeGreaterThan(0);
    await store.remove(gone);
    expect(entries(`WHERE robot = '${gone}'`)).toBe(0);
    expect((await store.commandsAfter(ROBOTS[1] ?? "", 0, 200)).length).toBe(100);
  });
});
