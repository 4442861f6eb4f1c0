import { describe, expect, it } from "vitest";
import { createScreenStore, showMessage } from "../stores/screen-store.ts";
import { createWorkspaceStore, setMaze } from "../stores/workspace-store.ts";
import { CurrentWork } from "./current-work.ts";
import { firstMaze, firstProgram } from "../worker/first-work.ts";
import { readWork } from "./read-work.ts";
import { MemoryStorage } from "./testing/memory-storage.ts";
import type { ToWorker } from "../worker/worker-messages.ts";
import { sendEdits } from "./send-edits.ts";
import { WorksService } from "./works-service.ts";
import { challengeKey, WorkShelf, type Work } from "./works.ts";

let lastId = 0;

/** The works of a tab: its own sessionStorage, the device's localStorage. Messages are their keys. */
function openTab(device: MemoryStorage) {
  const shelf = new WorkShelf(device, () => readWork);
  const ports = {
    shelf,
    tab: new MemoryStorage(),
    now: () => ++lastId,
    newId: () => `id-${++lastId}`,
  };
  const current = new CurrentWork(ports, firstMaze, firstProgram);
  const workspace = createWorkspaceStore(current.work.maze, current.work.program);
  const screen = createScreenStore();
  const words = { t: ((key: string) => key) as never };
  const later = () => undefined;
  const sent: string[] = [];
  const simulator = { send: ({ type }: ToWorker) => void sent.push(type) };
  sendEdits(workspace, simulator);
  const works = new WorksService({ shelf, current, workspace, screen, simulator, words, later });
  const shown = () => workspace.getState().maze.name;
  /** an edit that is saved, if there is room */
  const edit = (name: string) => {
    setMaze(workspace, { ...workspace.getState().maze, name });
    works.autosave.flush();
  };
  const listed = (name: string): Work => {
    const work = works.list().find(({ maze }) => maze.name === name);
    if (work === undefined) throw new Error(`no work is named ${name}`);
    return work;
  };
  const told = () => screen.getState().messages.map(({ text }) => text);
  const names = () =>
    shelf
      .list()
      .map(({ maze }) => maze.name)
      .toSorted();
  return { works, screen, shown, edit, listed, told, names, sent };
}

/** Two tabs: one has "Draft" open, two has "Other" open. */
function openTwoTabs() {
  const device = new MemoryStorage();
  const one = openTab(device);
  one.edit("Draft");
  const two = openTab(device);
  const back = two.works.begin({ ...firstMaze, name: "Other" }, firstProgram);
  return { device, one, two, back };
}

describe("works that another tab saves meanwhile", () => {
  it("opens what the other tab saved while the list was in sight", () => {
    const { one, two } = openTwoTabs();
    const listed = two.listed("Draft");
    one.edit("Draft, by one");
    two.works.open(listed);
    expect(two.shown()).toBe("Draft, by one");
    two.edit("Draft, by both");
    expect(two.told()).toEqual([]);
    expect(two.names()).toEqual(["Draft, by both", "Other"]);
  });

  it("goes back to what the other tab made of the work", () => {
    const { one, two, back } = openTwoTabs();
    one.edit("Draft, by one");
    back();
    expect(two.shown()).toBe("Draft, by one");
    two.edit("Draft, by both");
    expect(two.names()).toEqual(["Draft, by both", "Other"]);
  });

  it("keeps both versions when this tab goes back to edits that could not be saved", () => {
    const { device, one, two } = openTwoTabs();
    two.works.open(two.listed("Draft"));
    device.isFull = true;
    two.edit("Draft, by two");
    const back = two.works.begin({ ...firstMaze, name: "Link" }, firstProgram);
    device.isFull = false;
    one.edit("Draft, by one");
    back();
    expect(two.shown()).toBe("Draft, by two");
    two.works.autosave.flush();
    expect(two.told()).toEqual(["works.forked", "works.blocked"]);
    expect(two.names()).toEqual(["Draft, by one", "Draft, by two", "Other"]);
  });

  it("takes back the deletion of the newest version", () => {
    const { one, two } = openTwoTabs();
    const listed = two.listed("Draft");
    one.edit("Draft, by one");
    two.works.remove(listed);
    expect(two.names()).toEqual(["Other"]);
    two.screen.getState().messages[0]?.action?.run();
    expect(two.names()).toEqual(["Draft, by one", "Other"]);
  });

  it("does not take a deletion back over what the other tab saved after it", () => {
    const { one, two } = openTwoTabs();
    two.works.remove(two.listed("Draft"));
    one.edit("Draft, by one");
    two.screen.getState().messages[0]?.action?.run();
    expect(two.names()).toEqual(["Draft, by one", "Other"]);
  });
});

describe("works that hold the same", () => {
  it("are one where a maze is opened again, and two where a challenge begins", () => {
    const { two } = openTwoTabs();
    two.works.begin({ ...firstMaze, name: "Other" }, firstProgram);
    expect(two.names()).toEqual(["Draft", "Other"]);
    const own = two.works.currentId();
    const back = two.works.beginNew({ ...firstMaze, name: "Other" }, firstProgram);
    expect(two.works.currentId()).not.toBe(own);
    expect(two.names()).toEqual(["Draft", "Other", "Other"]);
    back();
    expect(two.works.currentId()).toBe(own);
  });
});

describe("a work with a challenge", () => {
  it("has it again when its deletion is taken back", () => {
    const { device, two } = openTwoTabs();
    const draft = two.listed("Draft");
    device.setItem(challengeKey(draft.id), "task");
    two.works.remove(draft);
    expect(device.getItem(challengeKey(draft.id))).toBeNull();
    two.screen.getState().messages[0]?.action?.run();
    expect(device.getItem(challengeKey(draft.id))).toBe("task");
  });

  it("leaves nothing behind that a new page does not clear", () => {
    const { device } = openTwoTabs();
    device.setItem(challengeKey("gone"), "task");
    openTab(device);
    expect(device.getItem(challengeKey("gone"))).toBeNull();
  });
});

describe("another work", () => {
  it("is never entered in the middle of a run: the robot goes to its start, back and forth", () => {
    const { works, edit, listed, sent } = openTab(new MemoryStorage());
    edit("Mine");
    sent.length = 0;
    const ways: (() => void)[] = [];
    ways.push(works.begin({ ...firstMaze, name: "Empty" }, null));
    ways.push(works.beginShared({ ...firstMaze, name: "Shared" }, null));
    ways.push(() => works.open(listed("Empty")));
    for (const way of ways) way();
    expect(sent.filter((type) => type === "reset")).toHaveLength(5);
    expect(sent.at(-1)).toBe("reset");
  });

  it("of a run that was opened leaves the robot where the run is", () => {
    const { works, sent } = openTab(new MemoryStorage());
    works.beginShared({ ...firstMaze, name: "Recorded" }, firstProgram, true);
    expect(sent).not.toContain("reset");
  });

  it("takes no Undo along that is meant for the work before", () => {
    const { works, screen, told } = openTab(new MemoryStorage());
    const action = { label: "Undo", run: () => undefined };
    showMessage(screen, { tone: "info", text: "Line 1 deleted.", action, isOfProject: true });
    showMessage(screen, { tone: "bad", text: "Not saved." });
    works.begin({ ...firstMaze, name: "Other" }, null);
    expect(told()).toEqual(["Not saved."]);
  });

  it("takes no edits away that could not be saved, however it was opened", () => {
    const device = new MemoryStorage();
    const { works, screen, shown, edit, listed } = openTab(device);
    edit("Stored");
    works.begin({ ...firstMaze, name: "Other" }, null);
    device.isFull = true;
    edit("Never stored");
    const dismissAll = () => screen.setState({ messages: [] });
    const goBack = () => screen.getState().messages[0]?.action?.run();
    works.open(listed("Stored"));
    expect(shown()).toBe("Stored");
    goBack();
    expect(shown()).toBe("Never stored");
    // The way that leads back is not only in the hand of who opened.
    dismissAll();
    const back = works.begin({ ...firstMaze, name: "Third" }, null);
    goBack();
    expect(shown()).toBe("Never stored");
    works.beginNew({ ...firstMaze, name: "Third" }, null);
    edit("Third, never stored");
    back();
    expect(shown()).toBe("Never stored");
    goBack();
    expect(shown()).toBe("Third, never stored");
  });
});
