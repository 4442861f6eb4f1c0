/** What every store must do, whichever database is behind it. */
import type { Command } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { completed } from "../../testing/messages.ts";
import type { KeyChange, NewCommand, PageState, SessionStore } from "../session-store.ts";

const ID = "AAAAAAAAAAAAAAAAAAAAAA";
const LEFT: Command = { action: "left 90" };
const STOP: Command = { action: "stop" };
const NOW = 5_000;
/** of the page that every robot here begins with */
const EPOCH = 1;
const sent: NewCommand = {
  driver: "driver-hash-of-this-robot",
  script: null,
  key: null,
  command: LEFT,
  acceptedAt: NOW,
  ttl: 10_000,
  deadline: NOW + 10_000,
  replace: false,
  lease: null,
  maxWaiting: 64,
  keep: 100,
};
const keyChange = (change: Partial<KeyChange>): KeyChange => ({
  add: [],
  remove: [],
  removeKind: null,
  most: 12,
  reason: "revoked",
  ...change,
});
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
    await store.takeOver(ID, nothingDone);
    const add = (command: Command, key: string | null = null, change: Partial<NewCommand> = {}) =>
      store.add(ID, { ...sent, command, key, ...change });
    const deliver = async (window: number, epoch = EPOCH): Promise<number[]> =>
      (await store.deliver(ID, epoch, window, NOW)).map(({ record }) => record.seq);
    const states = async (): Promise<string[]> =>
      (await store.commandsAfter(ID, 0, 100)).map(({ seq, state }) => `${seq} ${state}`);
    return { ...opened, add, deliver, states };
  }

  describe(`${name}: keys`, () => {
    const watch = { kind: "watch" as const, hash: "watcher-hash" };
    const first = { kind: "drive" as const, hash: "driver-hash-of-this-robot" };

    it("makes and revokes keys in one step, also for after a restart", async () => {
      const { store, reopen } = await withRobot();
      const change = keyChange({ add: [watch], remove: [first.hash] });
      const changed = { outcome: "changed", keys: [watch], ended: [] };
      expect(await store.changeKeys(ID, change)).toEqual(changed);
      const again = keyChange({ add: [first] });
      expect(await store.changeKeys(ID, again)).toMatchObject({ outcome: "changed" });
      const keys = (await (await reopen()).find(ID))?.keys ?? [];
      expect(keys.toSorted((a, b) => a.hash.localeCompare(b.hash))).toEqual([first, watch]);
    });

    it("refuses one too many and leaves all as it was, but revokes and replaces then, too", async () => {
      const { store } = await withRobot();
      const full = await store.changeKeys(ID, keyChange({ add: [watch], most: 1 }));
      expect(full).toEqual({ outcome: "full" });
      expect((await store.find(ID))?.keys).toEqual([first]);
      const change = keyChange({ add: [watch], remove: [first.hash], most: 1 });
      const replaced = await store.changeKeys(ID, change);
      expect(replaced).toEqual({ outcome: "changed", keys: [watch], ended: [] });
    });

    it("revokes all of a kind, whoever has made them", async () => {
      const { store } = await withRobot();
      const other = { kind: "drive" as const, hash: "of-another-relay" };
      await store.changeKeys(ID, keyChange({ add: [watch, other] }));
      const anew = { kind: "drive" as const, hash: "new" };
      const replaced = await store.changeKeys(ID, keyChange({ add: [anew], removeKind: "drive" }));
      expect(replaced).toEqual({ outcome: "changed", keys: [watch, anew], ended: [] });
    });

    it("takes back what a revoked key had sent, and stores nothing more of it", async () => {
      const { store, add, deliver, states } = await withRobot();
      const other = { kind: "drive" as const, hash: "e" };
      await store.changeKeys(ID, keyChange({ add: [other] }));
      await add(LEFT);
      await add(LEFT, null, { driver: "e" });
      await deliver(1);
      await add(LEFT);
      const change = keyChange({ remove: [sent.driver] });
      expect(await store.changeKeys(ID, change)).toMatchObject({
        ended: [{ record: { seq: 3, state: "cancelled", reason: "revoked" } }],
      });
      expect(await store.recalled(ID)).toEqual([{ seq: 1, reason: "revoked" }]);
      expect(await add(LEFT)).toEqual({ outcome: "revoked" });
      expect(await add(LEFT, null, { driver: "e" })).toMatchObject({ outcome: "stored" });
      expect(await states()).toEqual(["1 delivered", "2 accepted", "3 cancelled", "4 accepted"]);
    });

    it("has no keys where there is no robot", async () => {
      const { store } = await withRobot();
      const change = keyChange({ add: [watch] });
      expect(await store.changeKeys("B".repeat(22), change)).toEqual({ outcome: "no-session" });
    });
  });

  describe(`${name}: scripts that are away`, () => {
    const driver = "driver-hash-of-this-robot";
    const reason = "its script was sent away";
    const anna = { id: "AnnaAnna", driver, name: "Anna \u00fc \u2713", client: "Python" };
    const watcher = { kind: "watch" as const, hash: "watcher-hash" };
    const nameless = { id: "Nameless", driver, name: null, client: "curl" };

    it("stay away after a restart, each once, until they are let back", async () => {
      const { store, reopen } = await withRobot();
      expect((await store.find(ID))?.away).toEqual([]);
      await store.changeAway(ID, { add: anna, remove: null, reason, most: 16 });
      await store.changeAway(ID, { add: nameless, remove: null, reason, most: 16 });
      const again = await store.changeAway(ID, { add: anna, remove: null, reason, most: 2 });
      expect(again).toEqual({ outcome: "changed", away: [anna, nameless], ended: [] });
      const reopened = await reopen();
      expect((await reopened.find(ID))?.away).toEqual([anna, nameless]);
      const back = { add: null, remove: anna.id, reason, most: 16 };
      expect(await reopened.changeAway(ID, back)).toMatchObject({ away: [nameless] });
      await reopened.changeAway(ID, { add: null, remove: nameless.id, reason, most: 16 });
      expect((await reopened.find(ID))?.away).toEqual([]);
    });

    it("are only so many, and none where there is no robot", async () => {
      const { store } = await withRobot();
      await store.changeAway(ID, { add: anna, remove: null, reason, most: 1 });
      const one = { add: nameless, remove: null, reason, most: 1 };
      expect(await store.changeAway(ID, one)).toEqual({ outcome: "full" });
      expect((await store.find(ID))?.away).toEqual([anna]);
      expect(await store.changeAway("B".repeat(22), one)).toEqual({ outcome: "no-session" });
    });

    it("are gone with their key, and from the disk with the robot", async () => {
      const { store, holds } = await withRobot();
      const other = { ...nameless, driver: "another-hash" };
      await store.changeAway(ID, {
        add: { ...anna, name: "Annas-name" },
        remove: null,
        reason,
        most: 16,
      });
      await store.changeAway(ID, { add: other, remove: null, reason, most: 16 });
      await store.changeKeys(ID, keyChange({ add: [watcher], remove: [driver] }));
      expect((await store.find(ID))?.away).toEqual([other]);
      await store.remove(ID);
      expect(await holds("Annas-name")).toBe(false);
    });

    it("loses what it had sent: what waits ends, and the robot is asked for the rest", async () => {
      const { store, add, deliver, states } = await withRobot();
      const byAnna = { script: anna.id };
      await add(LEFT, null, byAnna);
      await add(LEFT);
      await deliver(2);
      await add(LEFT, null, byAnna);
      await add(LEFT);
      const result = await store.changeAway(ID, { add: anna, remove: null, reason, most: 16 });
      expect(result).toMatchObject({
        ended: [{ record: { seq: 3, state: "cancelled", reason }, script: anna.id }],
      });
      expect(await states()).toEqual(["1 delivered", "2 delivered", "3 cancelled", "4 accepted"]);
      expect(await store.recalled(ID)).toEqual([{ seq: 1, reason }]);
    });

    it("sends nothing while it is away, not even where a relay has not heard of it", async () => {
      const { store, add } = await withRobot();
      const byAnna = { script: anna.id };
      await store.changeAway(ID, { add: anna, remove: null, reason, most: 16 });
      expect(await add(LEFT, null, byAnna)).toEqual({ outcome: "sent-away" });
      expect(await add(LEFT)).toMatchObject({ outcome: "stored" });
      await store.changeAway(ID, { add: null, remove: anna.id, reason, most: 16 });
      expect(await add(LEFT, null, byAnna)).toMatchObject({ outcome: "stored" });
    });
  });

  describe(`${name}: remote driving that is paused`, () => {
    const reason = "the owner paused remote driving";

    it("takes back what was sent, all but stops, in the same step", async () => {
      const { store, add, deliver, states } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await deliver(2);
      await add(STOP);
      await add(LEFT);
      const ended = await store.pause(ID, true, reason);
      expect(ended).toMatchObject([{ record: { seq: 5, state: "cancelled", reason } }]);
      const all = ["1 delivered", "2 delivered", "3 cancelled", "4 accepted", "5 cancelled"];
      expect(await states()).toEqual(all);
      expect((await store.recalled(ID)).map(({ seq }) => seq)).toEqual([1, 2]);
    });

    it("refuses commands and frees their keys, but takes a stop and knows what it took before", async () => {
      const { store, add } = await withRobot();
      await add(LEFT, "key-0001");
      await store.pause(ID, true, reason);
      expect(await add(LEFT, "key-0002")).toEqual({ outcome: "paused" });
      expect(await add(LEFT, "key-0001")).toMatchObject({ outcome: "duplicate" });
      expect(await add(STOP, "key-0003")).toMatchObject({ outcome: "stored" });
      expect(await store.pause(ID, false, reason)).toEqual([]);
      expect(await add(LEFT, "key-0002")).toMatchObject({ outcome: "stored" });
    });

    it("stays so after a restart, and is nothing where there is no robot", async () => {
      const { store, add, reopen } = await withRobot();
      await add(LEFT);
      expect((await store.find(ID))?.isPaused).toBe(false);
      await store.pause(ID, true, reason);
      expect((await (await reopen()).find(ID))?.isPaused).toBe(true);
      expect(await store.pause("B".repeat(22), true, reason)).toBeNull();
    });
  });

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
      await store.changeKeys(ID, keyChange({ add: [{ kind: "drive", hash: "e" }] }));
      const other = { ...sent, driver: "e", key: "key-0001", command: STOP };
      expect(await store.add(ID, other)).toMatchObject({ outcome: "stored" });
    });

    it("refuses a command too many and leaves its key free, but never a stop", async () => {
      const { add, deliver } = await withRobot();
      const maxWaiting = 2;
      await add(LEFT, null, { maxWaiting });
      await add(LEFT, null, { maxWaiting });
      expect(await add(LEFT, "key-0001", { maxWaiting })).toEqual({ outcome: "full" });
      await deliver(1);
      expect(await add(LEFT, "key-0001", { maxWaiting })).toMatchObject({
        outcome: "stored",
        record: { seq: 3 },
      });
      expect(await add(STOP, null, { maxWaiting })).toMatchObject({ outcome: "stored" });
    });

    it("forgets old commands once they have ended, with their keys, and never an open one", async () => {
      const { add, store, states, deliver } = await withRobot();
      const keep = 2;
      await add(LEFT, "key-0001", { keep });
      await add(LEFT, "key-0002", { keep });
      await deliver(8);
      await store.end(ID, EPOCH, completed(2));
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
      await store.end(ID, EPOCH, completed(1));
      await add(STOP, null, { keep });
      expect(await states()).toEqual(["5 cancelled", "6 accepted"]);
    });

    it("forgets only the commands of the robot that got a new one", async () => {
      const { add, store, states, deliver } = await withRobot();
      await add(LEFT);
      await deliver(8);
      await store.end(ID, EPOCH, completed(1));
      const other = "BBBBBBBBBBBBBBBBBBBBBB";
      const keys = [{ kind: "drive" as const, hash: sent.driver }];
      await store.create({ id: other, createdAt: 1_000, keys });
      for (let n = 0; n < 3; n++) await store.add(other, { ...sent, keep: 1 });
      expect(await states()).toEqual(["1 completed"]);
    });

    it("stores nothing for a robot that is not there", async () => {
      const { store } = await open();
      expect(await store.add(ID, sent)).toEqual({ outcome: "no-session" });
      expect(await store.takeOver(ID, nothingDone)).toBeNull();
    });

    it("delivers in order, no more than the window", async () => {
      const { add, store, states, deliver } = await withRobot();
      for (let n = 0; n < 4; n++) await add(LEFT);
      const first = await store.deliver(ID, EPOCH, 3, NOW);
      expect(first.map(({ record }) => [record.seq, record.state])).toEqual([
        [1, "delivered"],
        [2, "delivered"],
        [3, "delivered"],
      ]);
      expect(await deliver(3)).toEqual([]);
      await store.start(ID, EPOCH, 1);
      expect(await deliver(3)).toEqual([4]);
      expect(await states()).toEqual(["1 started", "2 delivered", "3 delivered", "4 delivered"]);
    });

    it("lets a stop overtake: what waits is cancelled, what is delivered is the robot's to end", async () => {
      const { add, states, deliver } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await deliver(2);
      const stop = await add(STOP);
      expect(stop).toMatchObject({
        ended: [{ record: { seq: 3, reason: "stopped by command 4" } }],
      });
      expect(await deliver(2)).toEqual([4]);
      expect(await states()).toEqual(["1 delivered", "2 delivered", "3 cancelled", "4 delivered"]);
    });

    it("keeps the first ending for ever", async () => {
      const { add, store, deliver } = await withRobot();
      await add(LEFT);
      expect(await store.end(ID, EPOCH, completed(1))).toMatchObject({
        outcome: "over",
        record: { state: "accepted" },
      });
      await deliver(8);
      expect(await store.start(ID, EPOCH, 1)).toMatchObject({ state: "started" });
      expect(await store.start(ID, EPOCH, 1)).toBeNull();
      expect(await store.end(ID, EPOCH, completed(1))).toMatchObject({
        outcome: "ended",
        record: { state: "completed", distance: 100 },
      });
      expect(await store.end(ID, EPOCH, { ...completed(1), state: "collided" })).toMatchObject({
        outcome: "over",
        record: { state: "completed" },
      });
      expect(await store.end(ID, EPOCH, completed(9))).toEqual({ outcome: "over", record: null });
      expect(await store.abandon(ID, EPOCH, "gone")).toEqual([]);
      expect(await store.command(ID, 1)).toMatchObject({ state: "completed", pose: { x: 250 } });
    });

    it("ends what runs when the robot is gone, leaves what waits, and believes that page no more", async () => {
      const { add, store, deliver, states } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await deliver(2);
      await store.start(ID, EPOCH, 1);
      await store.abandon(ID, EPOCH, "the robot is gone");
      expect(await states()).toEqual(["1 cancelled", "2 cancelled", "3 accepted"]);
      expect(await store.end(ID, EPOCH, completed(1))).toMatchObject({
        outcome: "over",
        record: { state: "cancelled", reason: "the robot is gone" },
      });
      expect(await deliver(8)).toEqual([]);
      expect((await store.takeOver(ID, nothingDone))?.epoch).toBe(EPOCH + 2);
    });
  });

  describe(`${name}: time to live`, () => {
    const short = { ttl: 400, deadline: NOW + 400 };

    it("expires what waits too long, and says when the next is due", async () => {
      const { add, store, states } = await withRobot();
      await add(LEFT, null, short);
      await add(LEFT);
      expect(await store.expire(ID, NOW + 399)).toEqual({ ended: [], next: NOW + 400 });
      const { ended, next } = await store.expire(ID, NOW + 400);
      expect(ended).toMatchObject([
        { ttl: 400, record: { seq: 1, state: "expired", reason: "older than 0.4 s" } },
      ]);
      expect(next).toBe(NOW + 10_000);
      expect(await states()).toEqual(["1 expired", "2 accepted"]);
      expect(await store.expire(ID, NOW + 10_000)).toMatchObject({ next: null });
    });

    it("leaves to the robot what was delivered in time, and delivers nothing late", async () => {
      const { add, store, states } = await withRobot();
      await add(LEFT, null, short);
      await add(LEFT, null, short);
      expect(await store.deliver(ID, EPOCH, 1, NOW + 399)).toMatchObject([
        {
          record: { seq: 1 },
          driver: sent.driver,
          deadline: NOW + 400,
          replace: false,
          lease: null,
        },
      ]);
      expect(await store.deliver(ID, EPOCH, 8, NOW + 400)).toEqual([]);
      await store.expire(ID, NOW + 400);
      expect(await states()).toEqual(["1 delivered", "2 expired"]);
      expect(await store.end(ID, EPOCH, { ...completed(1), state: "expired" })).toMatchObject({
        outcome: "ended",
      });
    });

    it("refuses what comes too late and leaves its key free, but knows a key again at any age", async () => {
      const { add, states } = await withRobot();
      expect(await add(LEFT, "key-0001", { deadline: NOW })).toEqual({ outcome: "late" });
      expect(await add(LEFT, "key-0001")).toMatchObject({ outcome: "stored", record: { seq: 1 } });
      expect(await add(LEFT, "key-0001", { deadline: NOW })).toMatchObject({
        outcome: "duplicate",
      });
      expect(await states()).toEqual(["1 accepted"]);
    });

    it("gives nothing more time when the clock was set back", async () => {
      const { add, store, states } = await withRobot();
      await add(LEFT);
      expect(await store.deliver(ID, EPOCH, 8, NOW - 2_001)).toEqual([]);
      expect(await store.expire(ID, NOW - 2_000)).toMatchObject({ ended: [] });
      expect(await store.expire(ID, NOW - 2_001)).toMatchObject({ ended: [{ ttl: 10_000 }] });
      expect(await states()).toEqual(["1 expired"]);
    });

    it("still knows the deadlines after a restart", async () => {
      const { add, store, reopen } = await withRobot();
      await add(LEFT, null, short);
      await store.close();
      const again = await reopen();
      expect(await again.expire(ID, NOW)).toEqual({ ended: [], next: NOW + 400 });
    });
  });

  describe(`${name}: replacing and cancelling`, () => {
    it("supersedes what is accepted, and delivers what replaces past a full window", async () => {
      const { add, deliver, states, store } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await deliver(2);
      expect(await add(LEFT, null, { replace: true, maxWaiting: 1 })).toMatchObject({
        outcome: "stored",
        ended: [{ record: { seq: 3, state: "superseded", reason: "replaced by command 4" } }],
      });
      expect(await store.deliver(ID, EPOCH, 2, NOW)).toMatchObject([
        { record: { seq: 4 }, replace: true },
      ]);
      expect(await states()).toEqual(["1 delivered", "2 delivered", "3 superseded", "4 delivered"]);
    });

    it("keeps overtaken what was delivered before and never arrived", async () => {
      const { add, deliver, states, store } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await deliver(8);
      await add(LEFT, null, { replace: true });
      await add(LEFT);
      await store.takeOver(ID, { lastApplied: 1, fresh: false, endings: [] });
      expect(await states()).toEqual([
        "1 started",
        "2 superseded",
        "3 superseded",
        "4 accepted",
        "5 accepted",
      ]);
      await deliver(8, EPOCH + 1);
      await add(STOP);
      await store.expire(ID, NOW + 60_000);
      await store.takeOver(ID, { lastApplied: 1, fresh: false, endings: [] });
      expect((await states()).slice(3)).toEqual(["4 cancelled", "5 cancelled", "6 expired"]);
    });

    it("takes back what waits, for its sender only, and leaves to the robot what it has", async () => {
      const { add, deliver, store } = await withRobot();
      const by = { driver: sent.driver, reason: "cancelled by its sender" };
      await add(LEFT);
      await deliver(8);
      await add(LEFT);
      expect(await store.cancel(ID, 2, { ...by, driver: "e" })).toEqual({ outcome: "not-yours" });
      expect(await store.cancel(ID, 2, by)).toMatchObject({
        outcome: "cancelled",
        termed: { record: { state: "cancelled", reason: by.reason } },
      });
      expect(await store.cancel(ID, 2, by)).toMatchObject({ outcome: "over" });
      expect(await store.cancel(ID, 1, by)).toMatchObject({
        outcome: "delivered",
        record: { state: "delivered" },
      });
      expect(await store.cancel(ID, 3, by)).toEqual({ outcome: "no-command" });
    });

    it("keeps the wish to take back what the robot has, and ends by it what never arrived", async () => {
      const { add, deliver, store, states } = await withRobot();
      const by = { driver: sent.driver, reason: "cancelled by its sender" };
      for (let n = 0; n < 4; n++) await add(LEFT);
      await deliver(3);
      expect(await store.recalled(ID)).toEqual([]);
      for (const seq of [1, 2, 4]) await store.cancel(ID, seq, by);
      await store.cancel(ID, 2, { ...by, reason: "later" });
      expect(await store.recalled(ID)).toEqual([
        { seq: 1, reason: by.reason },
        { seq: 2, reason: by.reason },
      ]);
      await store.takeOver(ID, { lastApplied: 1, fresh: false, endings: [] });
      expect(await states()).toEqual(["1 started", "2 cancelled", "3 accepted", "4 cancelled"]);
      expect(await store.command(ID, 1)).toMatchObject({ reason: null });
      expect(await store.command(ID, 2)).toMatchObject({ reason: by.reason });
      expect(await store.recalled(ID)).toEqual([{ seq: 1, reason: by.reason }]);
      await store.end(ID, EPOCH + 1, completed(1));
      expect(await store.recalled(ID)).toEqual([]);
    });
  });

  describe(`${name}: a page takes the robot`, () => {
    it("raises the epoch, makes what never arrived wait again, and knows what had begun", async () => {
      const { add, store, states, deliver } = await withRobot();
      for (let n = 0; n < 4; n++) await add(LEFT);
      await deliver(8);
      const taken = await store.takeOver(ID, {
        lastApplied: 2,
        fresh: false,
        endings: [completed(1)],
      });
      expect(taken?.epoch).toBe(EPOCH + 1);
      expect(await states()).toEqual(["1 completed", "2 started", "3 accepted", "4 accepted"]);
      expect((await store.takeOver(ID, nothingDone))?.epoch).toBe(EPOCH + 2);
    });

    it("refuses the frames of the page before", async () => {
      const { add, store, deliver, states } = await withRobot();
      await add(LEFT);
      await deliver(8);
      await store.takeOver(ID, { lastApplied: 1, fresh: false, endings: [] });
      expect(await store.start(ID, EPOCH, 1)).toBeNull();
      expect(await store.end(ID, EPOCH, completed(1))).toMatchObject({ outcome: "over" });
      expect(await deliver(8, EPOCH)).toEqual([]);
      expect(await states()).toEqual(["1 started"]);
    });

    it("names the endings that come too late, and takes a repeated one for what it is", async () => {
      const { add, store, deliver } = await withRobot();
      await add(LEFT);
      await add(LEFT);
      await deliver(8);
      await store.end(ID, EPOCH, completed(1));
      await store.abandon(ID, EPOCH, "gone");
      const endings = [completed(1), completed(2)];
      const taken = await store.takeOver(ID, { lastApplied: 2, fresh: false, endings });
      expect(taken).toMatchObject({ changed: [], refused: [{ seq: 2, state: "cancelled" }] });
    });

    it("ends what a reloaded page had begun, and what a waiting stop had overtaken", async () => {
      const { add, store, states, deliver } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await deliver(8);
      await add(STOP);
      await store.takeOver(ID, { lastApplied: 1, fresh: true, endings: [] });
      expect(await states()).toEqual(["1 cancelled", "2 cancelled", "3 cancelled", "4 accepted"]);
      expect(await store.command(ID, 1)).toMatchObject({ reason: "the page was reloaded" });
    });

    it("lists the commands that have not ended, in order", async () => {
      const { add, store, deliver } = await withRobot();
      for (let n = 0; n < 4; n++) await add(LEFT);
      await deliver(3);
      await store.start(ID, EPOCH, 1);
      await store.end(ID, EPOCH, {
        seq: 2,
        state: "completed",
        reason: null,
        pose: null,
        distance: 0,
      });
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
      const { add, store, reopen, deliver } = await withRobot();
      await add(LEFT, "key-0001");
      await deliver(8);
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
