/** Requirements for every class store, for any database. */
import { describe, expect, it } from "vitest";
import type { ClassChanges, ClassStore, NewClass, StudentRow } from "../class-store.ts";
import { classRow } from "../testing/class-row.ts";

const ID = "AAAAAAAAAAAAAAAAAAAAAA";
const OTHER = "BBBBBBBBBBBBBBBBBBBBBB";
const NOW = 1_000;

const row = classRow({
  createdAt: NOW,
  names: ["Juniper the first", "Bo"],
  keys: [
    { kind: "teach", hash: "hash-of-the-teacher-key" },
    { kind: "show", hash: "hash-of-the-screen-key" },
  ],
});
const admits = { id: ID, student: null, endsAt: null };
const created: NewClass = { id: ID, row, lesson: '{"name":"a lesson"}', code: "hash-of-the-code" };

function student(number: number, change: Partial<StudentRow> = {}): StudentRow {
  return {
    student: number,
    name: number,
    renamesLeft: 2,
    key: `hash-of-student-${number}`,
    joinedAt: NOW,
    helpSince: null,
    progress: 0,
    programs: 0,
    returnCode: null,
    ...change,
  };
}

/** Changes after which the class has this version. */
function changes(version: number, change: Partial<ClassChanges> = {}): ClassChanges {
  return {
    row: { ...row, version },
    students: [],
    removed: [],
    progress: [],
    programs: [],
    lesson: null,
    newCodes: [],
    oldCodes: [],
    ...change,
  };
}

const fullOne = changes(1, {
  students: [student(1), student(12)],
  progress: [
    { student: 12, seq: 1, text: '{"what":"a first record"}' },
    { student: 1, seq: 1, text: '{"what":"opened"}' },
    { student: 12, seq: 2, text: '{"what":"a second record"}' },
  ],
  programs: [{ student: 12, text: '{"link":"a program"}' }],
  newCodes: [{ hash: "hash-of-a-return-code", student: 12, endsAt: 5_000 }],
});

export interface OpenClassStore {
  store: ClassStore;
  /** The same data, opened again as after a restart. */
  reopen: () => Promise<ClassStore>;
  /** Whether the text is still in the files on disk. */
  holds: (text: string) => Promise<boolean>;
}

/** @param open creates an empty store, which exists until the test ends */
export function classStoreCases(name: string, open: () => Promise<OpenClassStore>): void {
  const commit = (store: ClassStore, version: number, change: ClassChanges, id = ID) =>
    store.commit(id, version, change, "{}");

  describe(`${name}: classes`, () => {
    it("are found by id and code, with all that was stored, also after a restart", async () => {
      const { store, reopen } = await open();
      expect(await store.create(created)).toBe(true);
      expect(await store.load(ID)).toEqual({ row, students: [] });
      expect(await store.progress(ID)).toEqual([]);
      expect(await commit(store, 0, fullOne)).toBe("committed");
      const again = await reopen();
      const students = [student(1), student(12)];
      expect(await again.load(ID)).toEqual({ row: { ...row, version: 1 }, students });
      expect(await again.lesson(ID)).toBe(created.lesson);
      expect(await again.program(ID, 12)).toBe('{"link":"a program"}');
      expect(await again.program(ID, 1)).toBeNull();
      expect(await again.progress(ID)).toEqual([
        { student: 1, text: '{"what":"opened"}' },
        { student: 12, text: '{"what":"a first record"}' },
        { student: 12, text: '{"what":"a second record"}' },
      ]);
      expect(await again.findCode("hash-of-the-code")).toEqual(admits);
    });

    it("are unknown by any other id or code", async () => {
      const { store } = await open();
      await store.create(created);
      expect(await store.load(OTHER)).toBeNull();
      expect(await store.lesson(OTHER)).toBeNull();
      expect(await store.program(OTHER, 1)).toBeNull();
      expect(await store.progress(OTHER)).toEqual([]);
      expect(await store.findCode("another")).toBeNull();
      expect(await commit(store, 0, changes(1), OTHER)).toBe("no-class");
      expect(await store.remove(OTHER)).toBe(false);
    });

    it("change once for each version, whichever relay is first", async () => {
      const { store } = await open();
      await store.create(created);
      const both = [student(1), student(2)].map((each) =>
        commit(store, 0, changes(1, { students: [each] })),
      );
      expect((await Promise.all(both)).toSorted()).toEqual(["committed", "conflict"]);
      expect((await store.load(ID))?.students).toHaveLength(1);
      expect(await commit(store, 0, changes(2))).toBe("conflict");
      expect(await commit(store, 1, changes(2))).toBe("committed");
    });

    it("replace students, programs and the lesson", async () => {
      const { store } = await open();
      await store.create(created);
      await commit(store, 0, fullOne);
      const changed = student(12, { helpSince: 3_000, programs: 2 });
      const next = changes(2, {
        students: [changed],
        programs: [{ student: 12, text: '{"link":"a newer program"}' }],
        lesson: '{"name":"another lesson"}',
      });
      expect(await commit(store, 1, next)).toBe("committed");
      expect((await store.load(ID))?.students).toEqual([student(1), changed]);
      expect(await store.program(ID, 12)).toBe('{"link":"a newer program"}');
      expect(await store.lesson(ID)).toBe('{"name":"another lesson"}');
    });

    it("never share a code", async () => {
      const { store } = await open();
      await store.create(created);
      expect(await store.create({ ...created, id: OTHER })).toBe(false);
      expect(await store.load(OTHER)).toBeNull();
      expect(await store.create({ ...created, id: OTHER, code: "another" })).toBe(true);
      const newCodes = [{ hash: created.code, student: null, endsAt: null }];
      expect(await commit(store, 0, changes(1, { newCodes }), OTHER)).toBe("code-taken");
      expect((await store.load(OTHER))?.row.version).toBe(0);
    });

    it("replace their code, which another class can then use", async () => {
      const { store } = await open();
      await store.create(created);
      const next = changes(1, {
        newCodes: [{ hash: "new", student: null, endsAt: null }],
        oldCodes: [created.code],
      });
      expect(await commit(store, 0, next)).toBe("committed");
      expect(await store.findCode(created.code)).toBeNull();
      expect(await store.findCode("new")).toEqual(admits);
      expect(await store.create({ ...created, id: OTHER })).toBe(true);
    });

    it("have codes by which a student returns until a time", async () => {
      const { store } = await open();
      await store.create(created);
      await commit(store, 0, fullOne);
      const found = { id: ID, student: 12, endsAt: 5_000 };
      expect(await store.findCode("hash-of-a-return-code")).toEqual(found);
    });

    it("delete a student with everything from the files", async () => {
      const { store, holds } = await open();
      await store.create(created);
      await commit(store, 0, fullOne);
      expect(await holds("hash-of-student-12")).toBe(true);
      expect(await commit(store, 1, changes(2, { removed: [12] }))).toBe("committed");
      await store.erased();
      expect((await store.load(ID))?.students).toEqual([student(1)]);
      expect(await store.program(ID, 12)).toBeNull();
      expect(await store.progress(ID)).toEqual([{ student: 1, text: '{"what":"opened"}' }]);
      expect(await store.findCode("hash-of-a-return-code")).toBeNull();
      for (const text of ["hash-of-student-12", "a first record", "a program", "return-code"]) {
        expect(await holds(text)).toBe(false);
      }
    });

    it.each([
      {
        when: "they end",
        remove: async (store: ClassStore) => expect(await store.remove(ID)).toBe(true),
      },
      {
        when: "they were not used",
        remove: async (store: ClassStore) => {
          await store.touch(ID, 3_000);
          await store.touch(ID, 2_000);
          expect(await store.removeExpired({ lastUsedAt: 3_000, createdAt: NOW })).toEqual([]);
          expect(await store.removeExpired({ lastUsedAt: 3_001, createdAt: 0 })).toEqual([ID]);
        },
      },
      {
        when: "they are too old",
        remove: async (store: ClassStore) => {
          await store.touch(ID, 9_000);
          const before = { lastUsedAt: 0, createdAt: NOW + 1 };
          expect(await store.removeExpired(before)).toEqual([ID]);
        },
      },
    ])("are deleted from the files when $when", async ({ remove }) => {
      const { store, holds } = await open();
      await store.create(created);
      await commit(store, 0, fullOne);
      expect(await holds("Juniper the first")).toBe(true);
      await remove(store);
      expect(await store.load(ID)).toBeNull();
      expect(await store.findCode(created.code)).toBeNull();
      const texts = [
        "Juniper the first",
        "hash-of-the-teacher-key",
        "hash-of-the-code",
        "hash-of-student-1",
        "hash-of-a-return-code",
        "a first record",
        "a program",
        "a lesson",
      ];
      for (const text of texts) expect(await holds(text)).toBe(false);
      // Its code is free again.
      expect(await store.create({ ...created, id: OTHER })).toBe(true);
    });
  });
}
