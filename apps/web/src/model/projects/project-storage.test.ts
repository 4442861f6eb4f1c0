import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { readProject } from "./read-project.ts";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { challengeKey, ProjectStorage, type Project } from "./project-storage.ts";
import { storageOrNone } from "../storage/key-value-storage.ts";

function project(id: string, savedAt: number, edited = true): Project {
  return { id, savedAt, revision: `r-${id}`, edited, maze: firstMaze, program: firstProgram };
}

describe("ProjectStorage", () => {
  it("returns what was stored, newest first", () => {
    const store = new ProjectStorage(new MemoryStorage(), () => readProject);
    store.write(project("old", 1));
    store.write(project("new", 2));
    expect(store.list()).toEqual([project("new", 2), project("old", 1)]);
    expect(store.read("old")).toEqual(project("old", 1));
    store.remove("old");
    expect(store.read("old")).toBeNull();
  });

  it("leaves other entries in the same storage alone", () => {
    const storage = new MemoryStorage();
    storage.setItem("other.app", "{}");
    const store = new ProjectStorage(storage, () => readProject);
    expect(store.sweep()).toEqual([]);
    expect(store.list()).toEqual([]);
    expect(storage.getItem("other.app")).toBe("{}");
  });

  it.each([
    { name: "cut off", text: '{"maze":', reason: "unreadable text" },
    { name: "no object", text: "7", reason: "found no object" },
    { name: "without a maze", text: JSON.stringify({ program: firstProgram }), reason: "maze: " },
    {
      name: "with a broken row",
      text: JSON.stringify({ ...project("a", 1), maze: { ...firstMaze, blocks: ["..x"] } }),
      reason: "maze.blocks[0]: found",
    },
    {
      name: "with an unknown action",
      text: JSON.stringify({ ...project("a", 1), program: { ...firstProgram, default: "fly" } }),
      reason: "program.default: found",
    },
  ])("moves an entry aside that is $name, and reports why", ({ text, reason }) => {
    const storage = new MemoryStorage();
    storage.setItem("corridor.work.a", text);
    const store = new ProjectStorage(storage, () => readProject);
    expect(store.list()).toEqual([]);
    expect(store.sweep()).toEqual([
      { key: "corridor.work.a", reason: expect.stringContaining(reason) as string },
    ]);
    expect(storage.getItem("corridor.aside.a")).toBe(text);
    expect(store.sweep()).toEqual([]);
  });

  it("leaves a damaged entry in place if there is no room to move it", () => {
    const storage = new MemoryStorage();
    storage.setItem("corridor.work.a", "nonsense");
    storage.isFull = true;
    expect(new ProjectStorage(storage, () => readProject).sweep()).toHaveLength(1);
    expect(storage.getItem("corridor.work.a")).toBe("nonsense");
  });

  it("restores an entry that was moved aside once it can be parsed", () => {
    const storage = new MemoryStorage();
    storage.setItem("corridor.aside.a", JSON.stringify(project("a", 5)));
    storage.setItem("corridor.aside.b", "nonsense");
    const store = new ProjectStorage(storage, () => readProject);
    expect(store.sweep()).toEqual([]);
    expect(store.list()).toEqual([project("a", 5)]);
    expect(storage.getItem("corridor.aside.b")).toBe("nonsense");
  });

  it("deletes the oldest unedited copies beyond 30, never an edited project", () => {
    const store = new ProjectStorage(new MemoryStorage(), () => readProject);
    for (let n = 0; n < 28; n++) store.write(project(`edited-${n}`, n));
    for (let n = 0; n < 4; n++) store.write(project(`copy-${n}`, 100 + n, false));
    const ids = store.list().map(({ id }) => id);
    expect(ids).toHaveLength(30);
    expect(ids.slice(0, 2)).toEqual(["copy-3", "copy-2"]);
    for (let n = 0; n < 5; n++) store.write(project(`more-${n}`, 200 + n));
    expect(store.list().filter(({ edited }) => edited)).toHaveLength(33);
  });

  it("deletes and restores the challenge of a project together with it", () => {
    const storage = new MemoryStorage();
    const store = new ProjectStorage(storage, () => readProject);
    store.write(project("shared", 0, false));
    storage.setItem(challengeKey("shared"), "task");
    expect(store.remove("shared")).toBe("task");
    expect(storage.length).toBe(0);
    store.write(project("shared", 0, false), "task");
    expect(storage.getItem(challengeKey("shared"))).toBe("task");
    for (let n = 0; n < 30; n++) store.write(project(`edited-${n}`, n));
    expect(store.read("shared")).toBeNull();
    expect(storage.getItem(challengeKey("shared"))).toBeNull();
  });

  it("deletes challenges without a project, except for those of entries moved aside", () => {
    const storage = new MemoryStorage();
    const store = new ProjectStorage(storage, () => readProject);
    store.write(project("here", 1));
    storage.setItem("corridor.aside.damaged", "nonsense");
    for (const id of ["here", "damaged", "gone", "gone-too"]) {
      storage.setItem(challengeKey(id), "task");
    }
    store.sweepChallenges();
    expect(storage.getItem(challengeKey("here"))).toBe("task");
    expect(storage.getItem(challengeKey("damaged"))).toBe("task");
    expect(storage.length).toBe(4);
  });

  it("does not delete the copy that is being written", () => {
    const store = new ProjectStorage(new MemoryStorage(), () => readProject);
    for (let n = 0; n < 30; n++) store.write(project(`edited-${n}`, n));
    store.write(project("copy", 0, false));
    expect(store.read("copy")).not.toBeNull();
  });
});

describe("storageOrNone", () => {
  it("reads as empty and refuses writes if storage is forbidden", () => {
    const storage = storageOrNone(() => {
      throw new Error("forbidden");
    });
    const store = new ProjectStorage(storage, () => readProject);
    expect(store.list()).toEqual([]);
    expect(() => store.write(project("a", 1))).toThrow("forbidden");
  });
});
