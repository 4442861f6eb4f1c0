import { describe, expect, it } from "vitest";
import { createScreenStore } from "../screen/screen-store.ts";
import { createWorkspaceStore, openProject, setMaze, undo } from "../workspace/workspace-store.ts";
import { flushWhenHidden, startAutosave } from "./autosave.ts";
import { CurrentProject } from "./current-project.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { readProject } from "./read-project.ts";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { ProjectStorage } from "./project-storage.ts";

let lastId = 0;

/** A tab of the browser: its own sessionStorage, the device's localStorage. */
function openTab(device: MemoryStorage, session = new MemoryStorage()) {
  const store = new ProjectStorage(device, () => readProject);
  const ports = { store, tab: session, now: () => ++lastId, newId: () => `id-${++lastId}` };
  const current = new CurrentProject(ports, firstMaze, firstProgram);
  const { maze, program } = current.project;
  const workspace = createWorkspaceStore(maze, program);
  const screen = createScreenStore();
  const received: string[] = [];
  const timers: (() => void)[] = [];
  const autosave = startAutosave({
    current,
    workspace,
    screen,
    later: (run) => void timers.push(run),
    onFork: () => void received.push("fork"),
    onBlocked: () => void received.push("blocked"),
  });
  const rename = (name: string) => setMaze(workspace, { ...workspace.getState().maze, name });
  const wait = () => {
    for (const run of timers.splice(0)) run();
  };
  return { store, current, workspace, screen, received, timers, autosave, rename, wait, session };
}

const names = (store: ProjectStorage) => store.list().map(({ maze }) => maze.name);

describe("autosave", () => {
  it("leaves the device empty until the first edit", () => {
    const tab = openTab(new MemoryStorage());
    tab.autosave.flush();
    expect(names(tab.store)).toEqual([]);
  });

  it("reports that it stores, stores, and a reload restores the project", () => {
    const device = new MemoryStorage();
    const tab = openTab(device);
    tab.rename("Mine");
    expect(tab.screen.getState().saved).toBe("saving");
    tab.wait();
    expect(tab.screen.getState().saved).toBe("saved");
    expect(openTab(device, tab.session).current.project.maze.name).toBe("Mine");
  });

  it("saves many quick edits with one timer, the newest state of all", () => {
    const tab = openTab(new MemoryStorage());
    for (const name of ["a", "b", "c"]) tab.rename(name);
    expect(tab.timers).toHaveLength(1);
    tab.wait();
    expect(names(tab.store)).toEqual(["c"]);
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
    expect(names(tab.store)).toEqual([]);
    hidden = true;
    listeners.get("visibilitychange")?.();
    expect(names(tab.store)).toEqual(["Mine"]);
    tab.rename("Mine 2");
    listeners.get("pagehide")?.();
    expect(names(tab.store)).toEqual(["Mine 2"]);
  });

  it("has nothing to store after an edit that was reverted", () => {
    const tab = openTab(new MemoryStorage());
    tab.rename("Mine");
    undo(tab.workspace);
    tab.wait();
    expect(names(tab.store)).toEqual([]);
    expect(tab.screen.getState().saved).toBe("saved");
  });

  it("reports once that the storage is full, and recovers with the first write that fits", () => {
    const device = new MemoryStorage();
    const tab = openTab(device);
    device.isFull = true;
    tab.rename("a");
    tab.wait();
    tab.rename("b");
    tab.wait();
    expect(tab.screen.getState().saved).toBe("blocked");
    expect(tab.received).toEqual(["blocked"]);
    device.isFull = false;
    tab.rename("c");
    tab.wait();
    expect(tab.screen.getState().saved).toBe("saved");
    expect(names(tab.store)).toEqual(["c"]);
  });
});

describe("projects in several tabs", () => {
  it("opens the newest project in a new tab, and each tab's own project after a reload", () => {
    const device = new MemoryStorage();
    const one = openTab(device);
    one.rename("One");
    one.wait();
    const two = openTab(device);
    expect(two.current.project.maze.name).toBe("One");
    two.current.begin({ ...firstMaze, name: "Two" }, firstProgram);
    expect(openTab(device, one.session).current.project.maze.name).toBe("One");
    expect(openTab(device, two.session).current.project.maze.name).toBe("Two");
  });

  it("retains both versions of a project that two tabs edit", () => {
    const device = new MemoryStorage();
    const one = openTab(device);
    one.rename("Draft");
    one.wait();
    const two = openTab(device);
    two.rename("Second tab");
    two.wait();
    one.rename("First tab");
    one.wait();
    expect(one.received).toEqual(["fork"]);
    expect(two.received).toEqual([]);
    expect(names(one.store).toSorted()).toEqual(["First tab", "Second tab"]);
    one.rename("First tab, later");
    one.wait();
    expect(one.received).toEqual(["fork"]);
    expect(names(one.store).toSorted()).toEqual(["First tab, later", "Second tab"]);
  });

  it("opens a listed project as another tab has stored it since, and does not fork it", () => {
    const device = new MemoryStorage();
    const one = openTab(device);
    one.rename("Old");
    one.wait();
    const two = openTab(device);
    two.current.begin({ ...firstMaze, name: "Other" }, firstProgram);
    const listed = two.store.read(one.current.project.id) ?? one.current.project;
    one.rename("New");
    one.wait();
    const { maze, program } = two.current.open(listed);
    expect(maze.name).toBe("New");
    openProject(two.workspace, maze, program);
    two.rename("Newest");
    two.wait();
    expect(two.received).toEqual([]);
    expect(names(two.store).toSorted()).toEqual(["Newest", "Other"]);
  });

  it("stores a project again that another tab deleted while it was edited here", () => {
    const device = new MemoryStorage();
    const one = openTab(device);
    one.rename("Draft");
    one.wait();
    openTab(device).store.remove(one.current.project.id);
    one.rename("Still here");
    one.wait();
    expect(names(one.store)).toEqual(["Still here"]);
  });

  it("continues with the newest project if the tab's own was deleted", () => {
    const device = new MemoryStorage();
    const one = openTab(device);
    one.rename("Chosen");
    one.wait();
    one.session.setItem("corridor.current", "no-such-project");
    expect(openTab(device, one.session).current.project.maze.name).toBe("Chosen");
  });
});
