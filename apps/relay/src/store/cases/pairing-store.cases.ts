/** Requirements for every pairing store, for any database. */
import { describe, expect, it } from "vitest";
import type { PairingQuestion, PairingState, PairingStore } from "../pairing-store.ts";
import type { RobotStore } from "../robot-store.ts";

const ROBOT = "AAAAAAAAAAAAAAAAAAAAAA";
const OTHER = "BBBBBBBBBBBBBBBBBBBBBB";
const pairing = { robot: ROBOT, code: "hash-of-the-code", endsAt: 600_000 };
const question = { key: "hash-of-the-new-key", name: "Right wall", client: "Python" };
const NOW = 1_000;
/** A script uses the code. */
const ask = (store: PairingStore, asked: PairingQuestion = question, now = NOW): Promise<boolean> =>
  store.transition({ code: pairing.code }, { from: "open", to: "asked", question: asked }, now);
/** The owner answers. */
const settle = (store: PairingStore, to: PairingState, key = question.key, now = NOW) =>
  store.transition({ key }, { from: "asked", to }, now);

export interface OpenPairingStore {
  store: PairingStore;
  robots: RobotStore;
  /** The same data, opened again as after a restart. */
  reopen: () => Promise<PairingStore>;
  /** Whether the text is still in the files on disk. */
  holds: (text: string) => Promise<boolean>;
}

/** @param open creates an empty store, which exists until the test ends */
export function pairingStoreCases(name: string, open: () => Promise<OpenPairingStore>): void {
  const withRobots = async () => {
    const opened = await open();
    for (const id of [ROBOT, OTHER]) await opened.robots.create({ id, createdAt: 1, keys: [] });
    return opened;
  };

  describe(`${name}: pairing codes`, () => {
    it("are found by robot, code and key, also after a restart", async () => {
      const { store, reopen } = await withRobots();
      expect(await store.open(pairing)).toBe("opened");
      const opened = { ...pairing, state: "open", question: null };
      expect(await store.find({ robot: ROBOT }, NOW)).toEqual(opened);
      expect(await store.find({ code: pairing.code }, NOW)).toEqual(opened);
      expect(await store.find({ key: question.key }, NOW)).toBeNull();
      expect(await ask(store)).toBe(true);
      const again = await reopen();
      const asked = { ...pairing, state: "asked", question };
      expect(await again.find({ key: question.key }, NOW)).toEqual(asked);
      expect(await again.find({ robot: OTHER }, NOW)).toBeNull();
    });

    it("are for one script, and the first answer is final", async () => {
      const { store } = await withRobots();
      await store.open(pairing);
      const second = { key: "hash-of-a-second-key", name: null, client: "curl" };
      const asked = [question, second].map((each) => ask(store, each));
      expect(await Promise.all(asked)).toEqual([true, false]);
      const answers = (["accepted", "refused"] as const).map((to) => settle(store, to));
      expect(await Promise.all(answers)).toEqual([true, false]);
      expect(await settle(store, "accepted", second.key)).toBe(false);
      expect(await store.find({ robot: ROBOT }, NOW)).toMatchObject({
        state: "accepted",
        question: { name: "Right wall" },
      });
    });

    it("belong to one robot, and a new one replaces the previous one", async () => {
      const { store } = await withRobots();
      await store.open(pairing);
      await ask(store);
      expect(await store.open({ ...pairing, robot: OTHER })).toBe("taken");
      expect(await store.open({ ...pairing, robot: "C".repeat(22) })).toBe("no-robot");
      expect(await store.open({ ...pairing, code: "another" })).toBe("opened");
      expect(await store.find({ code: pairing.code }, NOW)).toBeNull();
      expect(await store.find({ key: question.key }, NOW)).toBeNull();
      expect(await store.open({ ...pairing, robot: OTHER })).toBe("opened");
    });

    it("are valid until they expire, to the millisecond", async () => {
      const { store } = await withRobots();
      await store.open(pairing);
      expect(await store.find({ robot: ROBOT }, pairing.endsAt - 1)).not.toBeNull();
      expect(await store.find({ robot: ROBOT }, pairing.endsAt)).toBeNull();
      expect(await ask(store, question, pairing.endsAt)).toBe(false);
      expect(await ask(store)).toBe(true);
      expect(await settle(store, "accepted", question.key, pairing.endsAt)).toBe(false);
    });

    it.each([
      {
        when: "they are withdrawn",
        remove: async ({ store }: OpenPairingStore) => expect(await store.remove(ROBOT)).toBe(true),
      },
      {
        when: "they expire",
        remove: async ({ store }: OpenPairingStore) => {
          expect(await store.removeEnded(pairing.endsAt - 1)).toBe(0);
          expect(await store.removeEnded(pairing.endsAt)).toBe(1);
        },
      },
      {
        when: "their robot is deleted",
        remove: async ({ robots }: OpenPairingStore) => void (await robots.remove(ROBOT)),
      },
      {
        when: "their robot expires",
        remove: async ({ robots }: OpenPairingStore) =>
          void (await robots.removeExpired({ lastUsedAt: 10, createdAt: 10 })),
      },
    ])("are deleted from the files when $when", async ({ remove }) => {
      const opened = await withRobots();
      const { store, holds } = opened;
      await store.open(pairing);
      await ask(store);
      expect(await holds(question.key)).toBe(true);
      await remove(opened);
      expect(await store.find({ robot: ROBOT }, NOW)).toBeNull();
      expect(await store.find({ key: question.key }, NOW)).toBeNull();
      for (const text of [pairing.code, question.key, question.name]) {
        expect(await holds(text)).toBe(false);
      }
      expect(await store.remove(ROBOT)).toBe(false);
    });
  });
}
