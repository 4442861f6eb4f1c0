/** What every store must do, whichever database is behind it. */
import type { Command } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { completed } from "../../testing/messages.ts";
import type { PageState, SessionStore } from "../session-store.ts";

const ID = "AAAAAAAAAAAAAAAAAAAAAA";
const LEFT: Command = { action: "left 90" };
const STOP: Command = { action: "stop" };
const nothingDone: PageState = { lastApplied: 0, fresh: false, endings: [] };

export interface OpenStore {
  store: SessionStore;
  /** The same data, opened again as after a restart. */
  reopen: () => Promise<SessionStore>;
  /** Whether the text can still be found in what is on disk. */
  holds: (text: string) => Promise<boolean>;
}

/** @param open makes an empty store that goes with the test */
export function storeCases(name: string, open: () => Promise<OpenStore>): void {
  async function withRobot() {
    const opened = await open();
    const { store } = opened;
    const keys = [{ kind: "drive" as const, hash: "driver-hash-of-this-robot" }];
    await store.create({ id: ID, createdAt: 1_000, keys });
    const add = (
      command: Command,
      key: string | null = null,
      { maxWaiting = 64, keep = 100 }: { maxWaiting?: number; keep?: number } = {},
    ) => store.add(ID, { driver: "d", key, command, acceptedAt: 5_000, maxWaiting, keep });
    const states = async (): Promise<string[]> =>
      (await store.commandsAfter(ID, 0, 100)).map(({ seq, state }) => `${seq} ${state}`);
    return { ...opened, add, states };
  }

  describe(`${name}: commands`, () => {
    it("numbers commands 1, 2, 3 and keeps the whole request", async () => {
      const { add, store } = await withRobot();
      await add(LEFT);
      await add({ action: "drive", left: 0.2, right: -0.2, milliseconds: 602 }, "key-0001");
      expect(await store.command(ID, 2)).toEqual({
        seq: 2,
        key: "key-0001",
        action: "drive",
        command: { action: "drive", left: 0.2, right: -0.2, milliseconds: 602 },
        state: "accepted",
        reason: null,
        acceptedAt: "1970-01-01T00:00:05.000Z",
        pose: null,
        distance: null,
        duplicate: false,
      });
    });

    it("gives a retry the first record, and refuses the key for another command", async () => {
      const { add, states } = await withRobot();
      await add(LEFT, "key-0001");
      expect(await add(LEFT, "key-0001")).toMatchObject({
        outcome: "duplicate",
        record: { seq: 1 },
      });
      expect(await add(STOP, "key-0001")).toMatchObject({ outcome: "conflict" });
      expect(await states()).toEqual(["1 accepted"]);
    });

    it("lets another driver use the same key", async () => {
      const { add, store } = await withRobot();
      await add(LEFT, "key-0001");
      const other = { driver: "e", key: "key-0001", command: STOP, acceptedAt: 1 };
      expect(await store.add(ID, { ...other, maxWaiting: 64, keep: 100 })).toMatchObject({
        outcome: "stored",
      });
    });

    it("refuses a command too many and leaves its key free, but never a stop", async () => {
      const { add, store } = await withRobot();
      const maxWaiting = 2;
      await add(LEFT, null, { maxWaiting });
      await add(LEFT, null, { maxWaiting });
      expect(await add(LEFT, "key-0001", { maxWaiting })).toEqual({ outcome: "full" });
      await store.deliver(ID, 1, 1);
      expect(await add(LEFT, "key-0001", { maxWaiting })).toMatchObject({
        outcome: "stored",
        record: { seq: 3 },
      });
      expect(await add(STOP, null, { maxWaiting })).toMatchObject({ outcome: "stored" });
    });

    it("forgets old commands once they have ended, with their keys, and never an open one", async () => {
      const { add, store, states } = await withRobot();
      const keep = 2;
      await add(LEFT, "key-0001", { keep });
      await add(LEFT, "key-0002", { keep });
      await store.deliver(ID, 1, 8);
      await store.end(ID, completed(2));
      await add(LEFT, "key-0003", { keep });
      expect(await states()).toEqual(["1 delivered", "2 completed", "3 accepted"]);
      await add(LEFT, "key-0004", { keep });
      expect(await states()).toEqual(["1 delivered", "3 accepted", "4 accepted"]);
      expect(await store.command(ID, 2)).toBeNull();
      expect(await add(LEFT, "key-0003", { keep })).toMatchObject({ outcome: "duplicate" });
      expect(await add(LEFT, "key-0002", { keep })).toMatchObject({
        outcome: "stored",
        record: { seq: 5 },
      });
      await store.end(ID, completed(1));
      await add(STOP, null, { keep });
      expect(await states()).toEqual(["5 cancelled", "6 accepted"]);
    });

    it("forgets only the commands of the robot that got a new one", async () => {
      const { add, store, states } = await withRobot();
      await add(LEFT);
      await store.deliver(ID, 1, 8);
      await store.end(ID, completed(1));
      const other = "BBBBBBBBBBBBBBBBBBBBBB";
      await store.create({ id: other, createdAt: 1_000, keys: [] });
      const command = { driver: "d", key: null, command: LEFT, acceptedAt: 1, maxWaiting: 64 };
      for (let n = 0; n < 3; n++) await store.add(other, { ...command, keep: 1 });
      expect(await states()).toEqual(["1 completed"]);
    });

    it("stores nothing for a robot that is not there", async () => {
      const { store } = await open();
      const command = { driver: "d", key: null, command: LEFT, acceptedAt: 1, maxWaiting: 64 };
      expect(await store.add(ID, { ...command, keep: 100 })).toEqual({ outcome: "no-session" });
      expect(await store.takeOver(ID, nothingDone)).toBeNull();
    });

    it("delivers in order, no more than the window", async () => {
      const { add, store, states } = await withRobot();
      for (let n = 0; n < 4; n++) await add(LEFT);
      const first = await store.deliver(ID, 1, 3);
      expect(first.map(({ seq, state }) => [seq, state])).toEqual([
        [1, "delivered"],
        [2, "delivered"],
        [3, "delivered"],
      ]);
      expect(await store.deliver(ID, 1, 3)).toEqual([]);
      await store.start(ID, 1);
      expect((await store.deliver(ID, 1, 3)).map(({ seq }) => seq)).toEqual([4]);
      expect(await states()).toEqual(["1 started", "2 delivered", "3 delivered", "4 delivered"]);
    });

    it("lets a stop overtake: what waits is cancelled, what is delivered is the robot's to end", async () => {
      const { add, store, states } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await store.deliver(ID, 1, 2);
      const stop = await add(STOP);
      expect(stop).toMatchObject({ ended: [{ seq: 3, reason: "stopped by command 4" }] });
      expect((await store.deliver(ID, 1, 2)).map(({ seq }) => seq)).toEqual([4]);
      expect(await states()).toEqual(["1 delivered", "2 delivered", "3 cancelled", "4 delivered"]);
    });

    it("keeps the first ending for ever", async () => {
      const { add, store } = await withRobot();
      await add(LEFT);
      expect(await store.end(ID, completed(1))).toBeNull();
      await store.deliver(ID, 1, 8);
      expect(await store.start(ID, 1)).toMatchObject({ state: "started" });
      expect(await store.start(ID, 1)).toBeNull();
      expect(await store.end(ID, completed(1))).toMatchObject({
        state: "completed",
        distance: 100,
      });
      expect(await store.end(ID, { ...completed(1), state: "collided" })).toBeNull();
      expect(await store.cancelOpen(ID, "gone")).toEqual([]);
      expect(await store.command(ID, 1)).toMatchObject({ state: "completed", pose: { x: 250 } });
    });

    it("ends what runs when the robot is gone, and leaves alone what waits", async () => {
      const { add, store, states } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await store.deliver(ID, 1, 2);
      await store.start(ID, 1);
      await store.cancelOpen(ID, "the robot is gone");
      expect(await states()).toEqual(["1 cancelled", "2 cancelled", "3 accepted"]);
    });
  });

  describe(`${name}: a page takes the robot`, () => {
    it("raises the epoch, makes what never arrived wait again, and knows what had begun", async () => {
      const { add, store, states } = await withRobot();
      for (let n = 0; n < 4; n++) await add(LEFT);
      await store.deliver(ID, 1, 8);
      const taken = await store.takeOver(ID, {
        lastApplied: 2,
        fresh: false,
        endings: [completed(1)],
      });
      expect(taken?.epoch).toBe(1);
      expect(await states()).toEqual(["1 completed", "2 started", "3 accepted", "4 accepted"]);
      expect((await store.takeOver(ID, nothingDone))?.epoch).toBe(2);
    });

    it("ends what a reloaded page had begun, and what a waiting stop had overtaken", async () => {
      const { add, store, states } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await store.deliver(ID, 1, 8);
      await add(STOP);
      await store.takeOver(ID, { lastApplied: 1, fresh: true, endings: [] });
      expect(await states()).toEqual(["1 cancelled", "2 cancelled", "3 cancelled", "4 accepted"]);
      expect(await store.command(ID, 1)).toMatchObject({ reason: "the page was reloaded" });
    });

    it("lists the commands that have not ended, in order", async () => {
      const { add, store } = await withRobot();
      for (let n = 0; n < 4; n++) await add(LEFT);
      await store.deliver(ID, 1, 3);
      await store.start(ID, 1);
      await store.end(ID, { seq: 2, state: "completed", reason: null, pose: null, distance: 0 });
      const open = await store.openCommands(ID);
      expect(open.map(({ seq, state }) => `${seq} ${state}`)).toEqual([
        "1 started",
        "3 delivered",
        "4 accepted",
      ]);
      expect(await store.openCommands("BBBBBBBBBBBBBBBBBBBBBB")).toEqual([]);
    });

    it("never gives a number again that the page has seen", async () => {
      const { add, store } = await withRobot();
      await store.takeOver(ID, { lastApplied: 41, fresh: false, endings: [] });
      expect(await add(LEFT)).toMatchObject({ record: { seq: 42 } });
    });
  });

  describe(`${name}: sessions`, () => {
    it("answers that it can be written, as often as it is asked", async () => {
      const { store, add, states } = await withRobot();
      await add(LEFT);
      expect([await store.check(), await store.check()]).toEqual(["ok", "ok"]);
      expect(await states()).toEqual(["1 accepted"]);
    });

    it("still has everything after a restart", async () => {
      const { add, store, reopen } = await withRobot();
      await add(LEFT, "key-0001");
      await store.deliver(ID, 1, 8);
      await store.close();
      const again = await reopen();
      expect(await again.find(ID)).toMatchObject({
        id: ID,
        createdAt: 1_000,
        keys: [{ kind: "drive" }],
      });
      expect(await again.command(ID, 1)).toMatchObject({ state: "delivered", key: "key-0001" });
    });

    it("deletes a session with all of its traces", async () => {
      const { add, store, holds } = await withRobot();
      await add(LEFT, "a-key-to-be-forgotten");
      expect(await holds("a-key-to-be-forgotten")).toBe(true);
      expect(await store.remove(ID)).toBe(true);
      expect(await store.remove(ID)).toBe(false);
      expect(await store.find(ID)).toBeNull();
      expect(await store.commandsAfter(ID, 0, 10)).toEqual([]);
      expect(await holds("a-key-to-be-forgotten")).toBe(false);
      expect(await holds("driver-hash-of-this-robot")).toBe(false);
    });

    it("forgets sessions that nobody uses or that are too old, and no others", async () => {
      const { store } = await withRobot();
      await store.create({ id: "BBBBBBBBBBBBBBBBBBBBBB", createdAt: 9_000, keys: [] });
      await store.touch(ID, 8_000);
      expect(await store.removeExpired({ lastUsedAt: 7_000, createdAt: 0 })).toEqual([]);
      expect(await store.removeExpired({ lastUsedAt: 8_500, createdAt: 0 })).toEqual([ID]);
      expect(await store.removeExpired({ lastUsedAt: 0, createdAt: 9_001 })).toEqual([
        "BBBBBBBBBBBBBBBBBBBBBB",
      ]);
    });
  });
}
