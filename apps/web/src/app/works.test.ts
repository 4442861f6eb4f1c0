import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../worker/first-work.ts";
import { readWork } from "./read-work.ts";
import { MemoryStorage } from "./testing/memory-storage.ts";
import { challengeKey, storageOrNone, WorkShelf, type Work } from "./works.ts";

function work(id: string, savedAt: number, edited = true): Work {
  return { id, savedAt, revision: `r-${id}`, edited, maze: firstMaze, program: firstProgram };
}

describe("WorkShelf", () => {
  it("gives back what was put in, newest first", () => {
    const shelf = new WorkShelf(new MemoryStorage(), () => readWork);
    shelf.write(work("old", 1));
    shelf.write(work("new", 2));
    expect(shelf.list()).toEqual([work("new", 2), work("old", 1)]);
    expect(shelf.read("old")).toEqual(work("old", 1));
    shelf.remove("old");
    expect(shelf.read("old")).toBeNull();
  });

  it("leaves entries of others in the same storage alone", () => {
    const storage = new MemoryStorage();
    storage.setItem("other.app", "{}");
    const shelf = new WorkShelf(storage, () => readWork);
    expect(shelf.sweep()).toEqual([]);
    expect(shelf.list()).toEqual([]);
    expect(storage.getItem("other.app")).toBe("{}");
  });

  it.each([
    { name: "cut off", text: '{"maze":', reason: "unreadable text" },
    { name: "no object", text: "7", reason: "found no object" },
    { name: "without a maze", text: JSON.stringify({ program: firstProgram }), reason: "maze: " },
    {
      name: "with a broken row",
      text: JSON.stringify({ ...work("a", 1), maze: { ...firstMaze, blocks: ["..x"] } }),
      reason: "maze.blocks[0]: found",
    },
    {
      name: "with an unknown action",
      text: JSON.stringify({ ...work("a", 1), program: { ...firstProgram, default: "fly" } }),
      reason: "program.default: found",
    },
  ])("keeps an entry that is $name aside and says why", ({ text, reason }) => {
    const storage = new MemoryStorage();
    storage.setItem("corridor.work.a", text);
    const shelf = new WorkShelf(storage, () => readWork);
    expect(shelf.list()).toEqual([]);
    expect(shelf.sweep()).toEqual([
      { key: "corridor.work.a", reason: expect.stringContaining(reason) as string },
    ]);
    expect(storage.getItem("corridor.aside.a")).toBe(text);
    expect(shelf.sweep()).toEqual([]);
  });

  it("keeps a damaged entry where it is when there is no room to move it", () => {
    const storage = new MemoryStorage();
    storage.setItem("corridor.work.a", "nonsense");
    storage.isFull = true;
    expect(new WorkShelf(storage, () => readWork).sweep()).toHaveLength(1);
    expect(storage.getItem("corridor.work.a")).toBe("nonsense");
  });

  it("takes back an entry that was moved aside once it can be read", () => {
    const storage = new MemoryStorage();
    storage.setItem("corridor.aside.a", JSON.stringify(work("a", 5)));
    storage.setItem("corridor.aside.b", "nonsense");
    const shelf = new WorkShelf(storage, () => readWork);
    expect(shelf.sweep()).toEqual([]);
    expect(shelf.list()).toEqual([work("a", 5)]);
    expect(storage.getItem("corridor.aside.b")).toBe("nonsense");
  });

  it("drops the oldest untouched copies beyond 30, never an edited work", () => {
    const shelf = new WorkShelf(new MemoryStorage(), () => readWork);
    for (let n = 0; n < 28; n++) shelf.write(work(`edited-${n}`, n));
    for (let n = 0; n < 4; n++) shelf.write(work(`copy-${n}`, 100 + n, false));
    const ids = shelf.list().map(({ id }) => id);
    expect(ids).toHaveLength(30);
    expect(ids.slice(0, 2)).toEqual(["copy-3", "copy-2"]);
    for (let n = 0; n < 5; n++) shelf.write(work(`more-${n}`, 200 + n));
    expect(shelf.list().filter(({ edited }) => edited)).toHaveLength(33);
  });

  it("lets the challenge of a work go with it, and brings it back with it", () => {
    const storage = new MemoryStorage();
    const shelf = new WorkShelf(storage, () => readWork);
    shelf.write(work("shared", 0, false));
    storage.setItem(challengeKey("shared"), "task");
    expect(shelf.remove("shared")).toBe("task");
    expect(storage.length).toBe(0);
    shelf.write(work("shared", 0, false), "task");
    expect(storage.getItem(challengeKey("shared"))).toBe("task");
    for (let n = 0; n < 30; n++) shelf.write(work(`edited-${n}`, n));
    expect(shelf.read("shared")).toBeNull();
    expect(storage.getItem(challengeKey("shared"))).toBeNull();
  });

  it("drops challenges whose work is gone, and keeps those of works that are there or aside", () => {
    const storage = new MemoryStorage();
    const shelf = new WorkShelf(storage, () => readWork);
    shelf.write(work("here", 1));
    storage.setItem("corridor.aside.damaged", "nonsense");
    for (const id of ["here", "damaged", "gone", "gone-too"]) {
      storage.setItem(challengeKey(id), "task");
    }
    shelf.sweepChallenges();
    expect(storage.getItem(challengeKey("here"))).toBe("task");
    expect(storage.getItem(challengeKey("damaged"))).toBe("task");
    expect(storage.length).toBe(4);
  });

  it("does not drop the copy that is being written", () => {
    const shelf = new WorkShelf(new MemoryStorage(), () => readWork);
    for (let n = 0; n < 30; n++) shelf.write(work(`edited-${n}`, n));
    shelf.write(work("copy", 0, false));
    expect(shelf.read("copy")).not.toBeNull();
  });
});

describe("storageOrNone", () => {
  it("reads as empty and refuses to keep anything where storage is forbidden", () => {
    const storage = storageOrNone(() => {
      throw new Error("forbidden");
    });
    const shelf = new WorkShelf(storage, () => readWork);
    expect(shelf.list()).toEqual([]);
    expect(() => shelf.write(work("a", 1))).toThrow("forbidden");
  });
});
