/** Steps with journal entries: memory and disk stay consistent, whatever the result of a write. */
import { setImmediate as turn } from "node:timers/promises";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { LOST, NOTHING, withJournal } from "../../cases/failing-journal.ts";

describe("steps that add entries", () => {
  it("are answered once their entries are on disk, in order", async () => {
    const { step, settled, onDisk } = withJournal();
    void step("a");
    void step("b");
    await Promise.resolve();
    expect([onDisk(), settled]).toEqual([[], []]);
    await turn();
    expect(onDisk()).toEqual(["a", "b"]);
    expect(settled).toEqual(["a stored", "b stored"]);
  });

  it("are answered after the steps whose changes they have read, even if they add no entries", async () => {
    const { journal, step, settled } = withJournal();
    void step("a");
    void step("look", () => undefined);
    await Promise.resolve();
    expect(settled).toEqual([]);
    await turn();
    expect(settled).toEqual(["a stored", "look stored"]);
    expect(journal.writes).toHaveLength(1);
  });

  it("share the transaction of a step that changes rows", async () => {
    const { journal, step, rows, hasRow, onDisk } = withJournal();
    const all = [step("a"), rows("b"), step("c")];
    expect(await Promise.all(all)).toEqual([["a"], ["a", "b"], ["a", "b", "c"]]);
    expect([hasRow(), onDisk()]).toEqual([["b"], ["a", "b", "c"]]);
    expect(journal.writes).toEqual([]);
  });

  it("are lost together if they cannot be written, and later ones see the state on disk", async () => {
    const { journal, step, rows, settled, onDisk } = withJournal();
    journal.fails = { lost: LOST };
    step("a").catch(() => undefined);
    step("look", () => undefined).catch(() => undefined);
    await turn();
    expect(settled).toEqual(["a lost", "look lost"]);
    expect(await Promise.all([step("b"), rows("c")])).toEqual([["b"], ["b", "c"]]);
    expect(onDisk()).toEqual(["b", "c"]);
  });

  it("do not affect other steps if one fails that added nothing", async () => {
    const { journal, step } = withJournal();
    const a = step("a");
    const bad = step("bad", () => {
      throw new Error("refused");
    });
    const b = step("b");
    await expect(bad).rejects.toThrow("refused");
    expect([await a, await b]).toEqual([["a"], ["a", "b"]]);
    expect(journal.writes).toHaveLength(1);
  });

  it("leave nothing of one that fails midway, in memory or on disk", async () => {
    const { journal, append, step, parts, onDisk } = withJournal();
    parts.due = NOTHING;
    const a = step("a");
    const bad = step("bad", () => {
      append("bad");
      throw new Error("half done");
    });
    const b = step("b");
    await expect(bad).rejects.toThrow("half done");
    expect([await a, await b]).toEqual([["a"], ["a", "b"]]);
    expect(onDisk()).toEqual(["a", "b"]);
    // Memory was invalid at the first write, so it must not have reached the tables.
    expect(journal.writes).toEqual([
      { names: ["a"], compaction: null },
      { names: ["b"], compaction: NOTHING },
    ]);
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
    const { db, commits, step, onDisk } = withJournal();
    void step("a");
    const alone = commits.alone(() => [db.isTransaction, onDisk()]);
    const failing = commits.alone(() => {
      throw new Error("no such pragma");
    });
    const b = step("b");
    expect(await alone).toEqual([false, ["a"]]);
    await expect(failing).rejects.toThrow("no such pragma");
    expect(await b).toEqual(["a", "b"]);
  });

  it("complete before the close, and are rejected afterwards", async () => {
    const { commits, step, rows, onDisk } = withJournal();
    const a = step("a");
    const b = rows("b");
    commits.close();
    expect(onDisk()).toEqual(["a", "b"]);
    for (const late of [step("late"), rows("late"), commits.alone(() => undefined)])
      await expect(late).rejects.toThrow("closed");
    expect([await a, await b]).toEqual([["a"], ["a", "b"]]);
  });
});

describe("compaction", () => {
  beforeEach(() => void vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] }));
  afterEach(() => void vi.useRealTimers());
  /** Passes the time after which no more steps are expected, twice. */
  const idle = (): void => void vi.advanceTimersByTime(20);

  it("is written with the next entries, and reports its result", async () => {
    const { journal, step, parts, compacted, onDisk } = withJournal();
    parts.due = NOTHING;
    const compactionError = new Error("no room for rows");
    journal.fails = { compactionError };
    await step("a");
    expect(journal.writes).toEqual([{ names: ["a"], compaction: NOTHING }]);
    expect([compacted, onDisk()]).toEqual([[compactionError], ["a"]]);
    journal.fails = { lost: LOST };
    await expect(step("b")).rejects.toBe(LOST);
    await step("c");
    expect(compacted).toEqual([compactionError, LOST, null]);
  });

  it("runs while nothing else is to be written, until everything is compacted, and never after the close", async () => {
    const { journal, commits, step, parts, compacted } = withJournal();
    parts.needsCompaction = true;
    await step("a");
    expect(compacted).toEqual([]);
    parts.due = NOTHING;
    idle();
    expect(journal.writes.at(-1)).toEqual({ names: [], compaction: NOTHING });
    for (let times = 1; times <= 3; times++) {
      expect(compacted.length).toBe(times);
      await turn();
    }
    commits.close();
    const { length } = journal.writes;
    await turn();
    idle();
    expect(journal.writes).toHaveLength(length);
  });

  it("is not retried endlessly if it fails, but with the next entries", async () => {
    const { journal, step, parts } = withJournal();
    parts.needsCompaction = true;
    await step("a");
    parts.due = NOTHING;
    journal.fails = { compactionError: new Error("no") };
    idle();
    expect(journal.writes).toHaveLength(2);
    await turn();
    idle();
    expect(journal.writes).toHaveLength(2);
    await step("b");
    expect(journal.writes.at(-1)).toEqual({ names: ["b"], compaction: NOTHING });
  });

  it("waits while steps arrive", async () => {
    const { journal, step, parts } = withJournal();
    parts.needsCompaction = true;
    await step("a");
    vi.advanceTimersByTime(9);
    await step("b");
    parts.due = NOTHING;
    vi.advanceTimersByTime(9);
    expect(journal.writes.map(({ compaction }) => compaction)).toEqual([null, null]);
    idle();
    expect(journal.writes.at(-1)?.compaction).toEqual(NOTHING);
  });

  it("also runs if every group changes rows", async () => {
    const { journal, rows, hasRow, parts, compacted } = withJournal();
    await rows("a");
    parts.due = NOTHING;
    await rows("b");
    expect(journal.writes).toEqual([{ names: [], compaction: NOTHING }]);
    expect(compacted).toEqual([null]);
    parts.due = null;
    await rows("c");
    expect(hasRow()).toEqual(["a", "b", "c"]);
  });
});
