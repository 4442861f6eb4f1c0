/** Requirements for every document store, for any database. */
import { describe, expect, it } from "vitest";
import type { DocumentStore, NewDocument } from "../document-store.ts";

const DAY_MS = 24 * 60 * 60 * 1000;
const document: NewDocument = {
  ids: ["BCDF", "GHJKL"],
  hash: "hash-of-the-text",
  text: '{"name":"a maze that may be deleted"}',
  keyHash: "hash-of-the-first-key",
  now: 1_000,
};

export interface OpenDocumentStore {
  store: DocumentStore;
  /** The same data, opened again as after a restart. */
  reopen: () => Promise<DocumentStore>;
  /** Whether the text is still in the files on disk. */
  holds: (text: string) => Promise<boolean>;
}

/** @param open creates an empty store, which exists until the test ends */
export function documentStoreCases(name: string, open: () => Promise<OpenDocumentStore>): void {
  describe(`${name}: documents behind short links`, () => {
    const read = (store: DocumentStore, id = "BCDF") => store.read(id, 2_000, DAY_MS);

    it("returns stored documents, also after a restart", async () => {
      const { store, reopen } = await open();
      expect(await store.add(document)).toBe("BCDF");
      expect(await read(store)).toBe(document.text);
      expect(await read(store, "BBBB")).toBeNull();
      await store.close();
      expect(await read(await reopen())).toBe(document.text);
    });

    it("returns the first id for the same text, and separate ids for other texts", async () => {
      const { store } = await open();
      await store.add(document);
      const again = { ...document, ids: ["BBBB"], keyHash: "hash-of-the-second-key" };
      expect(await store.add(again)).toBe("BCDF");
      expect(await read(store, "BBBB")).toBeNull();
      expect(await store.add({ ...again, hash: "another", text: "{}" })).toBe("BBBB");
      expect(await read(store, "BBBB")).toBe("{}");
    });

    it("returns the first id for the same text even if it is long, because no code was free", async () => {
      const { store } = await open();
      const long = { ...document, ids: ["abcdefghijkl"] };
      expect(await store.add(long)).toBe("abcdefghijkl");
      expect(await store.add({ ...document, keyHash: "k" })).toBe("abcdefghijkl");
    });

    it("uses the first free id, and reports if none is free", async () => {
      const { store } = await open();
      const texts = ["a", "b", "c"].map((hash) => ({ ...document, hash, text: `"${hash}"` }));
      const [first, second, third] = texts.map((each) => () => store.add(each));
      expect([await first?.(), await second?.()]).toEqual(["BCDF", "GHJKL"]);
      await expect(third?.()).rejects.toThrow("all candidate ids are in use");
      expect([await read(store), await read(store, "GHJKL")]).toEqual(['"a"', '"b"']);
      // Concurrent calls never receive the same id.
      const ids = ["LLLL", "MMMM", "NNNN", "PPPP", "QQQQ"];
      const added = await Promise.all(
        ids.map((hash) => store.add({ ...document, ids, hash, text: `"${hash}"` })),
      );
      expect(added.toSorted()).toEqual(ids);
    });

    it("deletes a document with its key, and leaves nothing on disk", async () => {
      const { store, holds } = await open();
      await store.add(document);
      expect(await holds("a maze that may be deleted")).toBe(true);
      expect(await store.remove("BCDF", "no-such-key")).toBe("wrong-key");
      expect(await read(store)).toBe(document.text);
      expect(await store.remove("BCDF", document.keyHash)).toBe("removed");
      expect(await store.remove("BCDF", document.keyHash)).toBe("no-document");
      expect(await read(store)).toBeNull();
      for (const text of ["a maze that may be deleted", document.keyHash, document.hash]) {
        expect(await holds(text)).toBe(false);
      }
    });

    it("retains a document that another client stored too, until that client deletes it", async () => {
      const { store } = await open();
      await store.add(document);
      await store.add({ ...document, keyHash: "hash-of-the-second-key" });
      expect(await store.remove("BCDF", document.keyHash)).toBe("removed");
      expect(await read(store)).toBe(document.text);
      expect(await store.remove("BCDF", document.keyHash)).toBe("wrong-key");
      expect(await store.remove("BCDF", "hash-of-the-second-key")).toBe("removed");
      expect(await read(store)).toBeNull();
    });

    it("deletes unused documents, and no others", async () => {
      const { store, holds } = await open();
      await store.add(document);
      await store.add({ ...document, ids: ["BBBB"], hash: "b", text: '"read"' });
      await store.add({ ...document, ids: ["CCCC"], hash: "c", text: '"stored again"' });
      expect(await store.read("BBBB", 3 * DAY_MS, DAY_MS)).toBe('"read"');
      const again = { hash: "c", keyHash: "k", now: 3 * DAY_MS };
      await store.add({ ...document, text: '"stored again"', ...again });
      expect(await store.removeUnused(2 * DAY_MS)).toBe(1);
      expect(await read(store)).toBeNull();
      expect(await holds("a maze that may be deleted")).toBe(false);
      expect(await read(store, "BBBB")).toBe('"read"');
      expect(await read(store, "CCCC")).toBe('"stored again"');
    });

    it("records uses at most at the given interval, and never moves one back", async () => {
      const { store } = await open();
      await store.add({ ...document, now: 3 * DAY_MS });
      await store.read("BCDF", 3 * DAY_MS + 5, DAY_MS);
      await store.read("BCDF", DAY_MS, DAY_MS);
      expect(await store.removeUnused(3 * DAY_MS)).toBe(0);
      expect(await store.removeUnused(3 * DAY_MS + 1)).toBe(1);
    });
  });
}
