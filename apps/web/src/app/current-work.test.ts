import { describe, expect, it } from "vitest";
import { createScreenStore } from "../stores/screen-store.ts";
import { createWorkspaceStore, openProject, setMaze, undo } from "../stores/workspace-store.ts";
import { flushWhenHidden, startAutosave } from "./autosave.ts";
import { CurrentWork } from "./current-work.ts";
import { firstMaze, firstProgram } from "../worker/first-work.ts";
import { readWork } from "./read-work.ts";
import { MemoryStorage } from "./testing/memory-storage.ts";
import { WorkShelf } from "./works.ts";

let lastId = 0;

/** A tab of the browser: its own sessionStorage, the device's localStorage. */
function openTab(device: MemoryStorage, session = new MemoryStorage()) {
  const shelf = new WorkShelf(device, () => readWork);
  const ports = { shelf, tab: session, now: () => ++lastId, newId: () => `id-${++lastId}` };
  const current = new CurrentWork(ports, firstMaze, firstProgram);
  const { maze, program } = current.work;
  const workspace = createWorkspaceStore(maze, program);
  const screen = createScreenStore();
  const told: string[] = [];
  const timers: (() => void)[] = [];
  const autosave = startAutosave({
    current,
    workspace,
    screen,
    later: (run) => void timers.push(run),
    onFork: () => void told.push("fork"),
    onBlocked: () => void told.push("blocked"),
  });
  const rename = (name: string) => setMaze(workspace, { ...workspace.getState().maze, name });
  const wait = () => {
    for (const run of timers.splice(0)) run();
  };
  return { shelf, current, workspace, screen, told, timers, autosave, rename, wait, session };
}

const names = (shelf: WorkShelf) => shelf.list().map(({ maze }) => maze.name);

describe("autosave", () => {
  it("leaves the device empty until the first edit", () => {
    const tab = openTab(new MemoryStorage());
    tab.autosave.flush();
    expect(names(tab.shelf)).toEqual([]);
  });

  it("says that it saves, saves, and a reload restores the work", () => {
    const device = new MemoryStorage();
    const tab = openTab(device);
    tab.rename("Mine");
    expect(tab.screen.getState().saved).toBe("saving");
    tab.wait();
    expect(tab.screen.getState().saved).toBe("saved");
    expect(openTab(device, tab.session).current.work.maze.name).toBe("Mine");
  });

  it("saves many quick edits with one timer, the newest state of all", () => {
    const tab = openTab(new MemoryStorage());
    for (const name of ["a", "b", "c"]) tab.rename(name);
    expect(tab.timers).toHaveLength(1);
    tab.wait();
    expect(names(tab.shelf)).toEqual(["c"]);
  });

  it("saves at once when the page is hidden or left", () => {
    const tab = openTab(new MemoryStorage());
    const listeners = new Map<string, () => void>();
    let hidden = false;
    flushWhenHidden(tab.autosave, {
      listen: (type, listener) => void listeners.set(type, listener),
      isHidden: () => hidden,
    });
    tab.rename("Mine");
    listeners.get("visibilitychange")?.();
    expect(names(tab.shelf)).toEqual([]);
    hidden = true;
    listeners.get("visibilitychange")?.();
    expect(names(tab.shelf)).toEqual(["Mine"]);
    tab.rename("Mine 2");
    listeners.get("pagehide")?.();
    expect(names(tab.shelf)).toEqual(["Mine 2"]);
  });

  it("has nothing to save after an edit that was taken back", () => {
    const tab = openTab(new MemoryStorage());
    tab.rename("Mine");
    undo(tab.workspace);
    tab.wait();
    expect(names(tab.shelf)).toEqual([]);
    expect(tab.screen.getState().saved).toBe("saved");
  });

  it("says once that the storage is full, and recovers with the first save that fits", () => {
    const device = new MemoryStorage();
    const tab = openTab(device);
    device.isFull = true;
    tab.rename("a");
    tab.wait();
    tab.rename("b");
    tab.wait();
    expect(tab.screen.getState().saved).toBe("blocked");
    expect(tab.told).toEqual(["blocked"]);
    device.isFull = false;
    tab.rename("c");
    tab.wait();
    expect(tab.screen.getState().saved).toBe("saved");
    expect(names(tab.shelf)).toEqual(["c"]);
  });
});

describe("works in several tabs", () => {
  it("opens the newest work in a new tab, and each tab's own work after a reload", () => {
    const device = new MemoryStorage();
    const one = openTab(device);
    one.rename("One");
    one.wait();
    const two = openTab(device);
    expect(two.current.work.maze.name).toBe("One");
    two.current.begin({ ...firstMaze, name: "Two" }, firstProgram);
    expect(openTab(device, one.session).current.work.maze.name).toBe("One");
    expect(openTab(device, two.session).current.work.maze.name).toBe("Two");
  });

  it("keeps both versions of a work that two tabs edit", () => {
    const device = new MemoryStorage();
    const one = openTab(device);
    one.rename("Draft");
    one.wait();
    const two = openTab(device);
    two.rename("Second tab");
    two.wait();
    one.rename("First tab");
    one.wait();
    expect(one.told).toEqual(["fork"]);
    expect(two.told).toEqual([]);
    expect(names(one.shelf).toSorted()).toEqual(["First tab", "Second tab"]);
    one.rename("First tab, later");
    one.wait();
    expect(one.told).toEqual(["fork"]);
    expect(names(one.shelf).toSorted()).toEqual(["First tab, later", "Second tab"]);
  });

  it("opens a listed work as another tab has saved it since, and does not fork from it", () => {
    const device = new MemoryStorage();
    const one = openTab(device);
    one.rename("Old");
    one.wait();
    const two = openTab(device);
    two.current.begin({ ...firstMaze, name: "Other" }, firstProgram);
    const listed = two.shelf.read(one.current.work.id) ?? one.current.work;
    one.rename("New");
    one.wait();
    const { maze, program } = two.current.open(listed);
    expect(maze.name).toBe("New");
    openProject(two.workspace, maze, program);
    two.rename("Newest");
    two.wait();
    expect(two.told).toEqual([]);
    expect(names(two.shelf).toSorted()).toEqual(["Newest", "Other"]);
  });

  it("stores a work again that another tab deleted while it was edited here", () => {
    const device = new MemoryStorage();
    const one = openTab(device);
    one.rename("Draft");
    one.wait();
    openTab(device).shelf.remove(one.current.work.id);
    one.rename("Still here");
    one.wait();
    expect(names(one.shelf)).toEqual(["Still here"]);
  });

  it("goes on with the newest work when the tab's own is gone", () => {
    const device = new MemoryStorage();
    const one = openTab(device);
    one.rename("Kept");
    one.wait();
    one.session.setItem("corridor.current", "no-such-work");
    expect(openTab(device, one.session).current.work.maze.name).toBe("Kept");
  });
});
