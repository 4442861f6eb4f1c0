/** Tests of the journal's real thread and file, and of their failures. */
import { once } from "node:events";
import { mkdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { DatabaseSync } from "node:sqlite";
import { setTimeout as wait } from "node:timers/promises";
import { Worker } from "node:worker_threads";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { acquireStep } from "../../../commands/page-transitions.ts";
import { addStep, deliverStep, endStep, pauseStep } from "../../../commands/state-machine.ts";
import { completed } from "../../../platform/testing/messages.ts";
import { testFolder } from "../../../testing/test-relay.ts";
import type { Entry, Compaction } from "./journal.ts";
import { SqliteFile } from "./sqlite-file.ts";
import { openDatabase } from "./sqlite-schema.ts";
import { SqliteRobotStore } from "../sqlite-robot-store.ts";
import { ID, NOW, pageState, sent } from "../../cases/robot-in-store.ts";
import { ThreadedJournal } from "./threaded-journal.ts";

function withThread(folder = testFolder()) {
  const threads = vi.spyOn(Worker.prototype, "postMessage");
  onTestFinished(() => threads.mockRestore());
  const path = join(folder, "corridor.sqlite");
  const db = openDatabase(path);
  const journal = new ThreadedJournal(path);
  onTestFinished(async () => {
    await journal.close();
    db.close();
  });
  const write = (entries: Entry[], compaction: Compaction | null = null) =>
    new Promise<{ lost: unknown; compactionError: unknown }>((resolve) =>
      journal.write(entries, compaction, (lost, compactionError) =>
        resolve({ lost, compactionError }),
      ),
    );
  const onDisk = () => db.prepare("SELECT id, robot, entry FROM journal").all();
  /** the first thread that received a write */
  const thread = (): Worker => {
    const [first] = threads.mock.contexts;
    if (!(first instanceof Worker)) throw new Error("Nothing was written.");
    return first;
  };
  return { db, path, journal, write, onDisk, thread };
}

/** Waits until a thread works on what it received: its event loop is no longer idle. */
async function untilBusy(thread: Worker): Promise<void> {
  const idleMs = () => thread.performance.eventLoopUtilization().idle;
  for (let before = NaN; before !== idleMs(); await wait(2)) before = idleMs();
}

const entry = (id: number): Entry => [id, "robot", `entry ${id}`];
const DONE = { lost: null, compactionError: null };

describe("the journal's thread", () => {
  it("reports entries only after they are on disk, in order", async () => {
    const { write, onDisk } = withThread();
    expect(await write([entry(1), entry(2)])).toEqual(DONE);
    expect(onDisk().length).toBe(2);
    expect(await write([entry(3)])).toEqual(DONE);
    expect(onDisk()).toEqual([1, 2, 3].map((id) => ({ id, robot: "robot", entry: `entry ${id}` })));
  });

  it("writes entries even if it cannot compact, and reports why", async () => {
    const { write, onDisk } = withThread();
    const bringing = [
      { robot: "robot", entries: [99], gone: [], upTo: 99, lastSeq: 1, openFrom: 1, deletedTo: 0 },
    ];
    const { lost, compactionError } = await write([entry(1)], { bringing, deleted: 1, stored: [] });
    expect(lost).toBeNull();
    expect(compactionError).toBeInstanceOf(Error);
    expect(onDisk().length).toBe(1);
    expect(await write([entry(2)], { bringing: [], deleted: 1, stored: [] })).toEqual(DONE);
    expect(onDisk()).toEqual([{ id: 2, robot: "robot", entry: "entry 2" }]);
  });

  it("reports errors of SQLite, leaves nothing of that write on disk, and continues", async () => {
    const { write, onDisk } = withThread();
    await write([entry(1)]);
    const { lost } = await write([entry(2), entry(1)]);
    expect(lost).toBeInstanceOf(Error);
    expect(lost).toMatchObject({ errcode: 1555, message: expect.stringContaining("UNIQUE") });
    expect(onDisk().length).toBe(1);
    expect(await write([entry(2)])).toEqual(DONE);
  });

  it("is replaced if it dies during a write, which is rejected", async () => {
    const { db, write, onDisk, thread } = withThread();
    await write([entry(1)]);
    // The thread waits for the lock of this transaction.
    db.exec("BEGIN IMMEDIATE");
    const dying = write([entry(2)]);
    await untilBusy(thread());
    const gone = thread().terminate();
    db.exec("ROLLBACK");
    await gone;
    expect((await dying).lost).toBeInstanceOf(Error);
    // A terminated thread holds no lock.
    db.exec("BEGIN IMMEDIATE; COMMIT");
    const before = onDisk().length;
    expect(await write([entry(3)])).toEqual(DONE);
    expect(onDisk().length).toBe(before + 1);
  });

  it("is replaced if it died while it was idle", async () => {
    const { write, thread, onDisk } = withThread();
    await write([entry(1)]);
    await thread().terminate();
    expect(await write([entry(2)])).toEqual(DONE);
    expect(onDisk().length).toBe(2);
  });

  it("rejects writes if it cannot start", async () => {
    const journal = new ThreadedJournal(join(testFolder(), "missing", "corridor.sqlite"));
    for (let times = 0; times < 2; times++) {
      const lost = await new Promise((resolve) => journal.write([entry(1)], null, resolve));
      expect(lost).toMatchObject({ message: expect.stringContaining("unable to open") });
    }
    await journal.close();
  });

  it("rejects writes while no new thread can start, and continues later", async () => {
    const { write, thread } = withThread();
    await write([entry(1)]);
    await thread().terminate();
    vi.spyOn(Worker.prototype, "ref").mockImplementationOnce(() => {
      throw new Error("no thread");
    });
    const { lost } = await write([entry(2)]);
    expect(lost).toMatchObject({ message: "no thread" });
    expect(await write([entry(3)])).toEqual(DONE);
  });

  it("can be closed after a failure, and the database with it", async () => {
    const path = join(testFolder(), "corridor.sqlite");
    const file = new SqliteFile(path, { isThreaded: true });
    rmSync(path);
    mkdirSync(path);
    await file.close();
    rmSync(path, { recursive: true });
    // The lock is free again.
    await expect(new SqliteFile(path, { waitMs: 0 }).close()).resolves.toBeUndefined();
  });

  it("exits when it is closed", async () => {
    const { path, db } = withThread();
    const post = vi.spyOn(Worker.prototype, "postMessage");
    const other = new ThreadedJournal(path);
    await new Promise((resolve) => other.write([entry(1)], null, resolve));
    const [thread] = post.mock.contexts as Worker[];
    const ended = thread && once(thread, "exit");
    await other.close();
    expect(await ended).toEqual([0]);
    db.exec("DROP TABLE journal");
  });
});

describe("a store whose journal has a thread", () => {
  async function withStore() {
    const posts = vi.spyOn(Worker.prototype, "postMessage");
    onTestFinished(() => posts.mockRestore());
    const path = join(testFolder(), "corridor.sqlite");
    const store = new SqliteRobotStore(new SqliteFile(path, { isThreaded: true }));
    onTestFinished(() => store.close());
    await store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: sent.driver }] });
    await store.commit(ID, acquireStep(pageState()));
    const add = (key: string | null = null) => store.commit(ID, addStep({ ...sent, key }));
    /** A second connection, which can block writes. */
    const other = new DatabaseSync(path);
    onTestFinished(() => other.close());
    const thread = (): Worker => posts.mock.contexts.at(-1) as Worker;
    return { path, store, add, other, thread };
  }

  it("has exactly the state on disk after the thread dies: no entry and no number twice", async () => {
    // No time passes for the store. On a slow machine it would write the steps in small groups,
    // which are written synchronously.
    vi.useFakeTimers({ toFake: ["performance"] });
    onTestFinished(() => void vi.useRealTimers());
    const { path, store, add, other, thread } = await withStore();
    // More entries than `AdaptiveJournal` writes synchronously, so the thread writes them.
    const several = (name: string) => [1, 2, 3, 4, 5].map((n) => add(`${name}-000${n}`));
    await Promise.all(several("first"));
    other.exec("BEGIN IMMEDIATE");
    const dying = several("dying");
    await untilBusy(thread());
    // These steps see the results of the failed write, so they run again.
    const behind = [add("behind-01"), store.commit(ID, deliverStep(1, 8, NOW)), add("behind-02")];
    const rows = store.commit(ID, pauseStep(true));
    const gone = thread().terminate();
    other.exec("ROLLBACK");
    await gone;
    const fates = await Promise.allSettled(dying);
    await Promise.all([...behind, rows]);
    expect(await add("behind-01")).toMatchObject({ outcome: "duplicate" });
    await store.commit(ID, pauseStep(false));
    for (const again of await Promise.all(several("dying")))
      expect(again).toMatchObject({ outcome: expect.stringMatching(/stored|dupl/) });
    const listed = await store.commandsAfter(ID, 0, 100);
    expect(new Set(fates.map(({ status }) => status))).toEqual(new Set(["rejected"]));
    expect(listed.map(({ seq }) => seq)).toEqual(Array.from({ length: 12 }, (_, n) => n + 1));
    expect(new Set(listed.map(({ key }) => key)).size).toBe(12);
    await store.close();
    const reopened = new SqliteRobotStore(path);
    onTestFinished(() => reopened.close());
    expect(await reopened.commandsAfter(ID, 0, 100)).toEqual(listed);
  });

  it("completes and stores all requests before it closes", async () => {
    const { store, add } = await withStore();
    const asked = [
      ...[1, 2, 3].map((n) => add(`key-000${n}`)),
      store.commit(ID, pauseStep(false)),
      store.commit(ID, deliverStep(1, 8, NOW)),
      store.commit(ID, endStep(1, completed(1))),
    ];
    const closed = store.close();
    await expect(add()).rejects.toThrow(/closed/);
    expect((await Promise.allSettled(asked)).map(({ status }) => status)).toEqual(
      asked.map(() => "fulfilled"),
    );
    // Both calls wait until the file is closed.
    await store.close();
    await closed;
  });
});
