/** Steps with journal entries: memory and disk stay consistent, whatever the result of a write. */
import { setImmediate as turn } from "node:timers/promises";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { LOST, NOTHING, withJournal } from "../../cases/slow-journal.ts";

describe("steps that add entries", () => {
  it("are answered once their entries are on disk; steps in the meantime are written next, in order", async () => {
    const { journal, step, settled } = withJournal();
    void step("a");
    void step("b");
    expect(journal.writing).toBeNull();
    await turn();
    expect(journal.names).toEqual(["a", "b"]);
    void step("c");
    const d = step("d");
    await turn();
    expect(journal.names).toEqual(["a", "b"]);
    expect(settled).toEqual([]);
    journal.notify();
    expect(journal.names).toEqual(["c", "d"]);
    await turn();
    expect(settled).toEqual(["a stored", "b stored"]);
    journal.notify();
    expect(await d).toEqual(["a", "b", "c", "d"]);
  });

  it("are answered after the steps whose changes they have read, even if they add no entries", async () => {
    const { journal, step, settled } = withJournal();
    void step("a");
    await turn();
    void step("look", () => undefined);
    await turn();
    expect(settled).toEqual([]);
    journal.notify();
    await turn();
    expect(settled).toEqual(["a stored", "look stored"]);
    expect(journal.writing).toBeNull();
  });

  it("delay a step that changes rows, and the steps after it", async () => {
    const { journal, step, rows, hasRow, settled } = withJournal();
    void step("a");
    await turn();
    void step("b");
    void rows("c");
    const d = step("d");
    await turn();
    expect(hasRow()).toEqual([]);
    journal.notify();
    // The waiting steps run together with the step that ran before, in one transaction.
    expect(await d).toEqual(["a", "b", "c", "d"]);
    expect(hasRow()).toEqual(["c"]);
    expect(settled).toEqual(["a stored", "b stored", "c stored", "d stored"]);
    expect(journal.writing).toBeNull();
  });

  it("are repeated if the changes that they have read are lost", async () => {
    const { journal, step, rows, settled, onDisk } = withJournal();
    void step("a").catch(() => undefined);
    await turn();
    const b = step("b");
    const c = rows("c");
    const d = step("d");
    journal.notify(LOST);
    expect(await Promise.all([b, c, d])).toEqual([["b"], ["b", "c"], ["b", "c", "d"]]);
    expect(onDisk()).toEqual(["b", "c", "d"]);
    expect(settled[0]).toBe("a lost");
  });

  it("do not affect other steps if one fails that added nothing", async () => {
    const { journal, step } = withJournal();
    const a = step("a");
    const bad = step("bad", () => {
      throw new Error("refused");
    });
    const b = step("b");
    await expect(bad).rejects.toThrow("refused");
    await turn();
    expect(journal.names).toEqual(["a", "b"]);
    journal.notify();
    expect([await a, await b]).toEqual([["a"], ["a", "b"]]);
  });

  it("leave nothing of one that fails midway, in memory or on disk", async () => {
    const { journal, append, step, parts, compacted } = withJournal();
    parts.due = NOTHING;
    const a = step("a");
    const bad = step("bad", () => {
      append("bad");
      throw new Error("half done");
    });
    const b = step("b");
    await expect(bad).rejects.toThrow("half done");
    await turn();
    expect(journal.names).toEqual(["a"]);
    // Memory is invalid at this point, so it must not reach the tables.
    expect(journal.writing?.compaction).toBeNull();
    journal.notify();
    await turn();
    expect(journal.writing).toMatchObject({ compaction: NOTHING });
    journal.notify();
    expect([await a, await b]).toEqual([["a"], ["a", "b"]]);
    expect(compacted).toEqual([null]);
  });

  it("leave nothing of one that fails after it changed rows, and earlier ones of its group remain", async () => {
    const { append, commits, rows, step, onDisk } = withJournal();
    const a = rows("a");
    const bad = commits.run(() => {
      append("bad");
      throw new Error("half done");
    });
    const b = step("b");
    await expect(bad).rejects.toThrow("half done");
    expect([await a, await b]).toEqual([["a"], ["a", "b"]]);
    expect(onDisk()).toEqual(["a", "b"]);
  });

  it("leave nothing in memory of a group whose commit fails", async () => {
    const { append, commits, rows, onDisk } = withJournal();
    const lost = commits.run(() => {
      append("lost");
      // The journal has a row with this number already.
      commits.append([1, "robot", "twice"]);
    });
    await expect(lost).rejects.toThrow(/UNIQUE/);
    expect(await rows("b")).toEqual(["b"]);
    expect(onDisk()).toEqual(["b"]);
  });

  it("are all on disk before work without a transaction, and later ones are not", async () => {
    const { db, journal, commits, step, onDisk } = withJournal();
    void step("a");
    await turn();
    void step("b");
    const alone = commits.alone(() => [db.isTransaction, onDisk()]);
    const failing = commits.alone(() => {
      throw new Error("no such pragma");
    });
    const c = step("c");
    journal.notify();
    expect(await alone).toEqual([false, ["a", "b"]]);
    await expect(failing).rejects.toThrow("no such pragma");
    journal.notify();
    expect(await c).toEqual(["a", "b", "c"]);
  });

  it("complete before the close, and are rejected afterwards", async () => {
    const { journal, commits, step, rows } = withJournal();
    const a = step("a");
    await turn();
    const b = rows("b");
    const closed = commits.close();
    for (const late of [step("late"), rows("late"), commits.alone(() => undefined)])
      await expect(late).rejects.toThrow("closed");
    expect(journal.isClosed).toBe(false);
    journal.notify();
    await closed;
    expect(journal.isClosed).toBe(true);
    expect([await a, await b]).toEqual([["a"], ["a", "b"]]);
  });
});

/** Each robot runs one step at a time, but there may be many robots, and the disk may hang. */
describe("many thousand steps", () => {
  const MANY = 150_000;

  it.each([
    { fate: "are all answered once the data that they depend on is on disk", lost: null },
    { fate: "are all repeated if that data is lost", lost: LOST },
  ])("$fate", { timeout: 30_000 }, async ({ lost }) => {
    const { journal, commits, step } = withJournal();
    step("a").catch(() => undefined);
    await turn();
    const all = Array.from({ length: MANY }, () => commits.run(() => 1, "memory"));
    const row = commits.run(() => 2);
    const after = Array.from({ length: MANY }, () => commits.run(() => 3, "memory"));
    journal.notify(lost);
    const sum = (await Promise.all([...all, row, ...after])).reduce((a, b) => a + b, 0);
    expect(sum).toBe(4 * MANY + 2);
  });
});

describe("compaction", () => {
  beforeEach(() => void vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] }));
  afterEach(() => void vi.useRealTimers());
  /** Passes the time after which the journal counts as idle, twice. */
  const idle = (): void => void vi.advanceTimersByTime(20);

  it("is written with the next entries, and reports its result", async () => {
    const { journal, step, parts, compacted } = withJournal();
    parts.due = NOTHING;
    void step("a");
    await turn();
    expect(journal.writing).toMatchObject({ compaction: NOTHING });
    const compactionError = new Error("no room for rows");
    journal.notify(null, compactionError);
    expect(compacted).toEqual([compactionError]);
    await turn();
    step("b").catch(() => undefined);
    await turn();
    journal.notify(LOST);
    expect(compacted).toEqual([compactionError, LOST]);
  });

  it("runs while nothing else is to be written, until everything is compacted, and never after the close", async () => {
    const { journal, commits, step, parts, compacted } = withJournal();
    parts.needsCompaction = true;
    void step("a");
    await turn();
    expect(journal.writing).toMatchObject({ compaction: null });
    parts.due = NOTHING;
    journal.notify();
    for (let times = 1; times <= 2; times++) {
      if (times === 1) idle();
      else await turn();
      expect(journal.writing).toMatchObject({ entries: [], compaction: NOTHING });
      journal.notify();
      expect(compacted.length).toBe(times);
    }
    await commits.close();
    await turn();
    idle();
    expect(journal.writing).toBeNull();
  });

  it("continues without a pause while nothing else is to be written", async () => {
    const { journal, step, parts } = withJournal();
    Object.assign(parts, { needsCompaction: true, due: NOTHING });
    void step("a");
    await turn();
    journal.notify();
    idle();
    expect(journal.writing).not.toBeNull();
    for (let times = 0; times < 3; times++) {
      journal.notify();
      await turn();
      expect(journal.writing).toMatchObject({ entries: [], compaction: NOTHING });
    }
    journal.notify();
    parts.due = null;
    void step("b");
    await turn();
    expect(journal.writing).toMatchObject({ compaction: null });
    expect(journal.writing?.entries).toHaveLength(1);
  });

  it("is not retried endlessly if it fails, but with the next entries", async () => {
    const { journal, step, parts } = withJournal();
    Object.assign(parts, { needsCompaction: true, due: NOTHING });
    void step("a");
    await turn();
    journal.notify(null, new Error("no"));
    idle();
    expect(journal.writing).not.toBeNull();
    journal.notify(null, new Error("no"));
    await turn();
    idle();
    expect(journal.writing).toBeNull();
    void step("b");
    await turn();
    expect(journal.writing).toMatchObject({ compaction: NOTHING });
  });

  it("also runs if every group changes rows", async () => {
    const { journal, rows, parts } = withJournal();
    await rows("a");
    expect(journal.writing).toBeNull();
    parts.due = NOTHING;
    await rows("b");
    expect(journal.writing).toMatchObject({ entries: [], compaction: NOTHING });
    parts.due = null;
    journal.notify();
  });

  it("delays a step that changes rows", async () => {
    const { journal, step, rows, hasRow, parts } = withJournal();
    parts.needsCompaction = true;
    void step("a");
    await turn();
    parts.due = NOTHING;
    journal.notify();
    idle();
    expect(journal.writing).not.toBeNull();
    const b = rows("b");
    expect(hasRow()).toEqual([]);
    parts.needsCompaction = false;
    journal.notify();
    await b;
    expect(hasRow()).toEqual(["b"]);
  });
});
