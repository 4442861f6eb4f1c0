/** Requirements for every store: the keys of a robot. */
import { describe, expect, it } from "vitest";
import { changeKeysStep } from "../../commands/permissions.ts";
import { recalledStep } from "../../commands/state-machine.ts";
import { because, ID, LEFT, sent, keyChange, type OpenStore, robotIn } from "./robot-in-store.ts";

export function keyCases(name: string, open: () => Promise<OpenStore>): void {
  const withRobot = () => robotIn(open);

  describe(`${name}: keys`, () => {
    const watch = { kind: "watch" as const, hash: "watcher-hash" };
    const first = { kind: "drive" as const, hash: "driver-hash-of-this-robot" };

    it("creates and revokes keys in one step, which survives a restart", async () => {
      const { store, reopen } = await withRobot();
      const change = keyChange({ add: [watch], remove: [first.hash] });
      const changed = { outcome: "changed", keys: [watch], ended: [] };
      expect(await store.commit(ID, changeKeysStep(change))).toEqual(changed);
      const again = keyChange({ add: [first] });
      expect(await store.commit(ID, changeKeysStep(again))).toMatchObject({ outcome: "changed" });
      const keys = (await (await reopen()).find(ID))?.keys ?? [];
      expect(keys.toSorted((a, b) => a.hash.localeCompare(b.hash))).toEqual([first, watch]);
    });

    it("rejects a key above the limit without changes, and can still revoke and replace keys", async () => {
      const { store } = await withRobot();
      const full = await store.commit(ID, changeKeysStep(keyChange({ add: [watch], most: 1 })));
      expect(full).toEqual({ outcome: "full" });
      expect((await store.find(ID))?.keys).toEqual([first]);
      const change = keyChange({ add: [watch], remove: [first.hash], most: 1 });
      const replaced = await store.commit(ID, changeKeysStep(change));
      expect(replaced).toEqual({ outcome: "changed", keys: [watch], ended: [] });
    });

    it("revokes all keys of a kind, of every creator", async () => {
      const { store } = await withRobot();
      const other = { kind: "drive" as const, hash: "of-another-relay" };
      await store.commit(ID, changeKeysStep(keyChange({ add: [watch, other] })));
      const anew = { kind: "drive" as const, hash: "new" };
      const replaced = await store.commit(
        ID,
        changeKeysStep(keyChange({ add: [anew], removeKind: { kind: "drive" } })),
      );
      expect(replaced).toEqual({ outcome: "changed", keys: [watch, anew], ended: [] });
    });

    it("stores what a key is for, and revokes keys of one kind and use", async () => {
      const { store, reopen } = await withRobot();
      const url = { kind: "drive" as const, use: "url" as const, hash: "in-a-url" };
      await store.commit(ID, changeKeysStep(keyChange({ add: [watch, url] })));
      const again = await reopen();
      const keys = (await again.find(ID))?.keys ?? [];
      expect(keys).toContainEqual(url);
      expect(keys).toContainEqual(first);
      const ofUrls = keyChange({ removeKind: { kind: "drive", use: "url" } });
      const ofScripts = keyChange({ removeKind: { kind: "drive" } });
      const left = async (change: typeof ofUrls) => {
        const result = await again.commit(ID, changeKeysStep(change));
        return result.outcome === "changed" ? result.keys.map(({ hash }) => hash) : [];
      };
      expect((await left(ofScripts)).toSorted()).toEqual([url.hash, watch.hash].toSorted());
      expect(await left(ofUrls)).toEqual([watch.hash]);
    });

    it("withdraws the commands of a revoked key, and stores no more of them", async () => {
      const { store, add, deliver, states } = await withRobot();
      const other = { kind: "drive" as const, hash: "e" };
      await store.commit(ID, changeKeysStep(keyChange({ add: [other] })));
      await add(LEFT);
      await add(LEFT, null, { driver: "e" });
      await deliver(1);
      await add(LEFT);
      const change = keyChange({ remove: [sent.driver] });
      expect(await store.commit(ID, changeKeysStep(change))).toMatchObject({
        ended: [{ record: { seq: 3, state: "cancelled", reason: because("revoked") } }],
      });
      expect(await store.commit(ID, recalledStep())).toEqual([{ seq: 1, cause: "revoked" }]);
      expect(await add(LEFT)).toEqual({ outcome: "revoked" });
      expect(await add(LEFT, null, { driver: "e" })).toMatchObject({ outcome: "stored" });
      expect(await states()).toEqual(["1 delivered", "2 accepted", "3 cancelled", "4 accepted"]);
    });

    it("returns when each valid key was created and last used, also after a restart", async () => {
      const { store, reopen, holds } = await withRobot();
      await store.commit(ID, changeKeysStep(keyChange({ add: [watch], now: 7_000 })));
      const made = { hash: first.hash, createdAt: 1_000, lastUsedAt: null };
      const times = async (from = store) =>
        (await from.keyTimes(ID)).toSorted((a, b) => a.createdAt - b.createdAt);
      expect(await times()).toEqual([
        made,
        { hash: watch.hash, createdAt: 7_000, lastUsedAt: null },
      ]);
      await store.touch(ID, 9_000, [
        { hash: watch.hash, at: 8_000 },
        { hash: "no key of this robot", at: 8_000 },
      ]);
      await store.touch(ID, 9_000, [{ hash: watch.hash, at: 7_500 }]);
      const again = await reopen();
      expect(await times(again)).toEqual([
        made,
        { hash: watch.hash, createdAt: 7_000, lastUsedAt: 8_000 },
      ]);
      await again.commit(ID, changeKeysStep(keyChange({ remove: [watch.hash] })));
      expect(await times(again)).toEqual([made]);
      expect(await again.keyTimes("B".repeat(22))).toEqual([]);
      await again.remove(ID);
      await again.touch(ID, 9_500, [{ hash: first.hash, at: 9_500 }]);
      expect(await again.find(ID)).toBeNull();
      expect(await holds(first.hash)).toBe(false);
    });

    it("has no keys for an unknown robot", async () => {
      const { store } = await withRobot();
      const change = keyChange({ add: [watch] });
      expect(await store.commit("B".repeat(22), changeKeysStep(change))).toEqual({
        outcome: "no-robot",
      });
    });
  });
}
