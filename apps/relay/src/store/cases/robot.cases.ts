/** Requirements for every store: robots. */
import { describe, expect, it } from "vitest";
import { changeBlockedStep, changeKeysStep, permitResetStep } from "../../commands/permissions.ts";
import { pauseStep, recalledStep } from "../../commands/state-machine.ts";
import { because, ID, LEFT, STOP, keyChange, type OpenStore, robotIn } from "./robot-in-store.ts";

export function robotCases(name: string, open: () => Promise<OpenStore>): void {
  const withRobot = () => robotIn(open);

  describe(`${name}: blocked scripts`, () => {
    const driver = "driver-hash-of-this-robot";
    const anna = { id: "AnnaAnna", driver, name: "Anna \u00fc \u2713", client: "Python" };
    const watcher = { kind: "watch" as const, hash: "watcher-hash" };
    const nameless = { id: "Nameless", driver, name: null, client: "curl" };

    it("stay blocked after a restart, each once, until they are unblocked", async () => {
      const { store, reopen } = await withRobot();
      expect((await store.find(ID))?.blocked).toEqual([]);
      await store.commit(ID, changeBlockedStep({ add: anna, remove: null, most: 16 }));
      await store.commit(ID, changeBlockedStep({ add: nameless, remove: null, most: 16 }));
      const again = await store.commit(ID, changeBlockedStep({ add: anna, remove: null, most: 2 }));
      expect(again).toEqual({ outcome: "changed", blocked: [anna, nameless], ended: [] });
      const reopened = await reopen();
      expect((await reopened.find(ID))?.blocked).toEqual([anna, nameless]);
      const back = { add: null, remove: anna.id, most: 16 };
      expect(await reopened.commit(ID, changeBlockedStep(back))).toMatchObject({
        blocked: [nameless],
      });
      await reopened.commit(ID, changeBlockedStep({ add: null, remove: nameless.id, most: 16 }));
      expect((await reopened.find(ID))?.blocked).toEqual([]);
    });

    it("are limited in number, and cannot be added to an unknown robot", async () => {
      const { store } = await withRobot();
      await store.commit(ID, changeBlockedStep({ add: anna, remove: null, most: 1 }));
      const one = { add: nameless, remove: null, most: 1 };
      expect(await store.commit(ID, changeBlockedStep(one))).toEqual({ outcome: "full" });
      expect((await store.find(ID))?.blocked).toEqual([anna]);
      expect(await store.commit("B".repeat(22), changeBlockedStep(one))).toEqual({
        outcome: "no-robot",
      });
    });

    it("are removed with their key, and from the disk with the robot", async () => {
      const { store, holds } = await withRobot();
      const other = { ...nameless, driver: "another-hash" };
      await store.commit(
        ID,
        changeBlockedStep({
          add: { ...anna, name: "Annas-name" },
          remove: null,
          most: 16,
        }),
      );
      await store.commit(ID, changeBlockedStep({ add: other, remove: null, most: 16 }));
      await store.commit(ID, changeKeysStep(keyChange({ add: [watcher], remove: [driver] })));
      expect((await store.find(ID))?.blocked).toEqual([other]);
      await store.remove(ID);
      expect(await holds("Annas-name")).toBe(false);
    });

    it("loses its commands: waiting ones end, and the robot is asked to end the rest", async () => {
      const { store, add, deliver, states } = await withRobot();
      const byAnna = { script: anna.id };
      await add(LEFT, null, byAnna);
      await add(LEFT);
      await deliver(2);
      await add(LEFT, null, byAnna);
      await add(LEFT);
      const result = await store.commit(
        ID,
        changeBlockedStep({ add: anna, remove: null, most: 16 }),
      );
      expect(result).toMatchObject({
        ended: [
          { record: { seq: 3, state: "cancelled", reason: because("blocked") }, script: anna.id },
        ],
      });
      expect(await states()).toEqual(["1 delivered", "2 delivered", "3 cancelled", "4 accepted"]);
      expect(await store.commit(ID, recalledStep())).toEqual([{ seq: 1, cause: "blocked" }]);
    });

    it("sends no commands while it is blocked, even at a relay that has not been notified", async () => {
      const { store, add } = await withRobot();
      const byAnna = { script: anna.id };
      await store.commit(ID, changeBlockedStep({ add: anna, remove: null, most: 16 }));
      expect(await add(LEFT, null, byAnna)).toEqual({ outcome: "blocked" });
      expect(await add(LEFT)).toMatchObject({ outcome: "stored" });
      await store.commit(ID, changeBlockedStep({ add: null, remove: anna.id, most: 16 }));
      expect(await add(LEFT, null, byAnna)).toMatchObject({ outcome: "stored" });
    });
  });

  describe(`${name}: paused remote driving`, () => {
    it("withdraws all commands except stops in the same step, and stores the cause, not a sentence", async () => {
      const { store, add, deliver, states, holds } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await deliver(2);
      await add(STOP);
      await add(LEFT);
      const ended = await store.commit(ID, pauseStep(true));
      expect(ended).toMatchObject([
        { record: { seq: 5, state: "cancelled", reason: because("paused") } },
      ]);
      const all = ["1 delivered", "2 delivered", "3 cancelled", "4 accepted", "5 cancelled"];
      expect(await states()).toEqual(all);
      expect((await store.commit(ID, recalledStep())).map(({ seq }) => seq)).toEqual([1, 2]);
      expect(await holds(because("paused").slice(0, 30))).toBe(false);
    });

    it("rejects commands without using their keys, accepts stops, and returns earlier records to retries", async () => {
      const { store, add } = await withRobot();
      await add(LEFT, "key-0001");
      await store.commit(ID, pauseStep(true));
      expect(await add(LEFT, "key-0002")).toEqual({ outcome: "paused" });
      expect(await add(LEFT, "key-0001")).toMatchObject({ outcome: "duplicate" });
      expect(await add(STOP, "key-0003")).toMatchObject({ outcome: "stored" });
      expect(await store.commit(ID, pauseStep(false))).toEqual([]);
      expect(await add(LEFT, "key-0002")).toMatchObject({ outcome: "stored" });
    });

    it("persists across a restart, and does not exist for an unknown robot", async () => {
      const { store, add, reopen } = await withRobot();
      await add(LEFT);
      expect((await store.find(ID))?.isPaused).toBe(false);
      await store.commit(ID, pauseStep(true));
      const again = await reopen();
      expect((await again.find(ID))?.isPaused).toBe(true);
      expect(await again.commit("B".repeat(22), pauseStep(true))).toBeNull();
    });
  });

  describe(`${name}: resets by scripts`, () => {
    const RESET = { action: "reset" } as const;

    it("are permitted until the owner forbids them, also after a restart", async () => {
      const { store, add, reopen } = await withRobot();
      expect((await store.find(ID))?.mayReset).toBe(true);
      expect(await add(RESET)).toMatchObject({ outcome: "stored" });
      expect(await store.commit(ID, permitResetStep(false))).toBe(true);
      expect(await add(RESET, "key-0001")).toEqual({ outcome: "reset-disabled" });
      expect(await add(LEFT)).toMatchObject({ outcome: "stored" });
      const again = await reopen();
      expect((await again.find(ID))?.mayReset).toBe(false);
      await again.commit(ID, permitResetStep(true));
      expect((await again.find(ID))?.mayReset).toBe(true);
      expect(await again.commit("B".repeat(22), permitResetStep(true))).toBe(false);
    });

    it("supersede the waiting commands in the same step", async () => {
      const { add, states } = await withRobot();
      await add(LEFT);
      await add(RESET);
      expect(await states()).toEqual(["1 superseded", "2 accepted"]);
    });
  });

  describe(`${name}: sessions`, () => {
    it("reports each time that the store is writable", async () => {
      const { store, add, states } = await withRobot();
      await add(LEFT);
      expect([await store.check(), await store.check()]).toEqual(["ok", "ok"]);
      expect(await states()).toEqual(["1 accepted"]);
    });

    it("restores everything after a restart", async () => {
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
      await add(LEFT, "a-key-to-be-deleted");
      expect(await holds("a-key-to-be-deleted")).toBe(true);
      expect(await store.remove(ID)).toBe(true);
      expect(await store.remove(ID)).toBe(false);
      expect(await store.find(ID)).toBeNull();
      expect(await store.commandsAfter(ID, 0, 10)).toEqual([]);
      expect(await holds("a-key-to-be-deleted")).toBe(false);
      expect(await holds("driver-hash-of-this-robot")).toBe(false);
    });

    it("deletes robots that are unused or too old, and no others", async () => {
      const { store } = await withRobot();
      await store.create({ id: "BBBBBBBBBBBBBBBBBBBBBB", createdAt: 9_000, keys: [] });
      await store.touch(ID, 8_000, []);
      expect(await store.removeExpired({ lastUsedAt: 7_000, createdAt: 0 })).toEqual([]);
      expect(await store.removeExpired({ lastUsedAt: 8_500, createdAt: 0 })).toEqual([ID]);
      expect(await store.removeExpired({ lastUsedAt: 0, createdAt: 9_001 })).toEqual([
        "BBBBBBBBBBBBBBBBBBBBBB",
      ]);
    });
  });
}
