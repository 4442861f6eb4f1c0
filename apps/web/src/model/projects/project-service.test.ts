import { describe, expect, it } from "vitest";
import { createScreenStore, showMessage } from "../screen/screen-store.ts";
import { createWorkspaceStore, setMaze, setProgram } from "../workspace/workspace-store.ts";
import { LessonsStorage } from "../lessons/lessons-storage.ts";
import { CurrentProject } from "./current-project.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { readProject } from "./read-project.ts";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import type { ToWorker } from "../../simulator/protocol/worker-messages.ts";
import { sendEdits } from "../workspace/send-edits.ts";
import { ProjectService } from "./project-service.ts";
import { challengeKey, ProjectStorage, type Project } from "./project-storage.ts";

let lastId = 0;

/**
 * The projects of a tab: its own sessionStorage, the device's localStorage. Messages are their
 * keys.
 */
function openTab(device: MemoryStorage) {
  const store = new ProjectStorage(device, () => readProject);
  const ports = {
    store,
    tab: new MemoryStorage(),
    now: () => ++lastId,
    newId: () => `id-${++lastId}`,
  };
  const current = new CurrentProject(ports, firstMaze, firstProgram);
  const workspace = createWorkspaceStore(current.project.maze, current.project.program);
  const screen = createScreenStore();
  const words = { t: ((key: string) => key) as never };
  const later = () => undefined;
  const sent: string[] = [];
  const simulator = { send: ({ type }: ToWorker) => void sent.push(type) };
  sendEdits(workspace, simulator);
  const tasks = new LessonsStorage(device);
  const projects = new ProjectService({
    store,
    tasks,
    current,
    workspace,
    screen,
    simulator,
    words,
    later,
  });
  const shown = () => workspace.getState().maze.name;
  /** an edit that is stored if there is room */
  const edit = (name: string) => {
    setMaze(workspace, { ...workspace.getState().maze, name });
    projects.autosave.flush();
  };
  const listed = (name: string): Project => {
    const project = projects.list().find(({ maze }) => maze.name === name);
    if (project === undefined) throw new Error(`no project is named ${name}`);
    return project;
  };
  const texts = () => screen.getState().messages.map(({ text }) => text);
  const names = () =>
    store
      .list()
      .map(({ maze }) => maze.name)
      .toSorted();
  const program = (name: string) => {
    setProgram(workspace, { ...firstProgram, name });
    projects.autosave.flush();
  };
  const shownProgram = () => workspace.getState().program.name;
  return {
    projects,
    tasks,
    screen,
    shown,
    shownProgram,
    edit,
    program,
    listed,
    texts,
    names,
    sent,
  };
}

/** Two tabs: one has "Draft" open, two has "Other" open. */
function openTwoTabs() {
  const device = new MemoryStorage();
  const one = openTab(device);
  one.edit("Draft");
  const two = openTab(device);
  const back = two.projects.begin({ ...firstMaze, name: "Other" }, firstProgram);
  return { device, one, two, back };
}

describe("projects that another tab stores meanwhile", () => {
  it("opens the version that the other tab stored while the list was open", () => {
    const { one, two } = openTwoTabs();
    const listed = two.listed("Draft");
    one.edit("Draft, by one");
    two.projects.open(listed);
    expect(two.shown()).toBe("Draft, by one");
    two.edit("Draft, by both");
    expect(two.texts()).toEqual([]);
    expect(two.names()).toEqual(["Draft, by both", "Other"]);
  });

  it("returns to the other tab's version of the project", () => {
    const { one, two, back } = openTwoTabs();
    one.edit("Draft, by one");
    back();
    expect(two.shown()).toBe("Draft, by one");
    two.edit("Draft, by both");
    expect(two.names()).toEqual(["Draft, by both", "Other"]);
  });

  it("retains both versions if this tab returns to edits that could not be stored", () => {
    const { device, one, two } = openTwoTabs();
    two.projects.open(two.listed("Draft"));
    device.isFull = true;
    two.edit("Draft, by two");
    const back = two.projects.begin({ ...firstMaze, name: "Link" }, firstProgram);
    device.isFull = false;
    one.edit("Draft, by one");
    back();
    expect(two.shown()).toBe("Draft, by two");
    two.projects.autosave.flush();
    expect(two.texts()).toEqual(["projects.forked", "projects.blocked"]);
    expect(two.names()).toEqual(["Draft, by one", "Draft, by two", "Other"]);
  });

  it("restores the newest version of a deleted project", () => {
    const { one, two } = openTwoTabs();
    const listed = two.listed("Draft");
    one.edit("Draft, by one");
    two.projects.remove(listed);
    expect(two.names()).toEqual(["Other"]);
    two.screen.getState().messages[0]?.action?.run();
    expect(two.names()).toEqual(["Draft, by one", "Other"]);
  });

  it("does not restore a deleted project over a version that the other tab stored after it", () => {
    const { one, two } = openTwoTabs();
    two.projects.remove(two.listed("Draft"));
    one.edit("Draft, by one");
    two.screen.getState().messages[0]?.action?.run();
    expect(two.names()).toEqual(["Draft, by one", "Other"]);
  });
});

describe("projects with equal documents", () => {
  it("are one if a maze is opened again, and two if a challenge starts", () => {
    const { two } = openTwoTabs();
    two.projects.begin({ ...firstMaze, name: "Other" }, firstProgram);
    expect(two.names()).toEqual(["Draft", "Other"]);
    const own = two.projects.currentId();
    const back = two.projects.beginNew({ ...firstMaze, name: "Other" }, firstProgram);
    expect(two.projects.currentId()).not.toBe(own);
    expect(two.names()).toEqual(["Draft", "Other", "Other"]);
    back();
    expect(two.projects.currentId()).toBe(own);
  });

  it("are two if one belongs to a task, which a run or a maze from a link does not solve", () => {
    const { projects, tasks } = openTab(new MemoryStorage());
    const maze = { ...firstMaze, name: "Task" };
    projects.beginNew(maze, firstProgram);
    const task = projects.currentId();
    tasks.storeChallenge(task, "task");
    projects.beginShared(maze, firstProgram, true);
    const mission = projects.currentId();
    expect(mission).not.toBe(task);
    tasks.add({ works: { "one-line": mission } });
    projects.beginShared(maze, firstProgram);
    expect([task, mission]).not.toContain(projects.currentId());
  });

  it("open a maze again with the user's newest program, not with the one from then", () => {
    const { projects, edit, program, shownProgram, listed, names } = openTab(new MemoryStorage());
    const maze = { ...firstMaze, name: "Maze" };
    edit("Mine");
    program("Old");
    projects.begin(maze, null);
    const copy = projects.currentId();
    projects.open(listed("Mine"));
    projects.begin(maze, null);
    expect(projects.currentId()).toBe(copy);
    projects.open(listed("Mine"));
    program("New");
    projects.begin(maze, null);
    expect(shownProgram()).toBe("New");
    expect(names()).toEqual(["Maze", "Maze", "Mine"]);
  });

  it("lead back from a run to the task, which nobody has edited", () => {
    const { projects, tasks, edit } = openTab(new MemoryStorage());
    edit("Mine");
    projects.beginNew({ ...firstMaze, name: "Task" }, firstProgram);
    const task = projects.currentId();
    tasks.storeChallenge(task, "task");
    const back = projects.beginShared({ ...firstMaze, name: "Recorded" }, firstProgram, true);
    back();
    expect(projects.currentId()).toBe(task);
  });
});

describe("a project with a challenge", () => {
  /** A tab whose project becomes a copy, because another tab has stored the project. */
  function fork(addTask: (tab: ReturnType<typeof openTab>, project: string) => void) {
    const device = new MemoryStorage();
    const one = openTab(device);
    one.edit("Draft");
    const original = one.projects.currentId();
    addTask(one, original);
    const opened = one.projects.opened();
    openTab(device).edit("Draft, by two");
    one.edit("Draft, by one");
    const copy = one.projects.currentId();
    expect(copy).not.toBe(original);
    expect(one.projects.opened()).toBe(opened);
    return { tasks: new LessonsStorage(device), original, copy };
  }

  it("continues it in both tabs that edit the project", () => {
    const { tasks, original, copy } = fork((tab, id) => tab.tasks.storeChallenge(id, "task"));
    expect(tasks.challengeOf(original)).toBe("task");
    expect(tasks.challengeOf(copy)).toBe("task");
  });

  it("continues a mission in the newest copy", () => {
    const { tasks, copy } = fork((tab, id) => tab.tasks.add({ works: { "one-line": id } }));
    expect(tasks.missionOf(copy)).toBe("one-line");
  });

  it("has it again after its deletion is reverted", () => {
    const { device, two } = openTwoTabs();
    const draft = two.listed("Draft");
    device.setItem(challengeKey(draft.id), "task");
    two.projects.remove(draft);
    expect(device.getItem(challengeKey(draft.id))).toBeNull();
    two.screen.getState().messages[0]?.action?.run();
    expect(device.getItem(challengeKey(draft.id))).toBe("task");
  });

  it("leaves nothing behind that a new page does not delete", () => {
    const { device } = openTwoTabs();
    device.setItem(challengeKey("gone"), "task");
    openTab(device);
    expect(device.getItem(challengeKey("gone"))).toBeNull();
  });
});

describe("another project", () => {
  it("never opens during a run: the robot is reset, back and forth", () => {
    const { projects, edit, listed, sent } = openTab(new MemoryStorage());
    edit("Mine");
    sent.length = 0;
    const ways: (() => void)[] = [];
    ways.push(projects.begin({ ...firstMaze, name: "Empty" }, null));
    ways.push(projects.beginShared({ ...firstMaze, name: "Shared" }, null));
    ways.push(() => projects.open(listed("Empty")));
    for (const way of ways) way();
    expect(sent.filter((type) => type === "reset")).toHaveLength(5);
    expect(sent.at(-1)).toBe("reset");
  });

  it("of an opened run leaves the robot where the run is", () => {
    const { projects, sent } = openTab(new MemoryStorage());
    projects.beginShared({ ...firstMaze, name: "Recorded" }, firstProgram, true);
    expect(sent).not.toContain("reset");
  });

  it("removes Undo messages of the previous project", () => {
    const { projects, screen, texts } = openTab(new MemoryStorage());
    const action = { label: "Undo", run: () => undefined };
    showMessage(screen, { tone: "info", text: "Line 1 deleted.", action, isOfProject: true });
    showMessage(screen, { tone: "bad", text: "Not saved." });
    projects.begin({ ...firstMaze, name: "Other" }, null);
    expect(texts()).toEqual(["Not saved."]);
  });

  it("preserves edits that could not be stored, however it was opened", () => {
    const device = new MemoryStorage();
    const { projects, screen, shown, edit, listed } = openTab(device);
    edit("Stored");
    projects.begin({ ...firstMaze, name: "Other" }, null);
    device.isFull = true;
    edit("Never stored");
    const dismissAll = () => screen.setState({ messages: [] });
    const goBack = () => screen.getState().messages[0]?.action?.run();
    projects.open(listed("Stored"));
    expect(shown()).toBe("Stored");
    goBack();
    expect(shown()).toBe("Never stored");
    // The message with the way back may have been dismissed.
    dismissAll();
    const back = projects.begin({ ...firstMaze, name: "Third" }, null);
    goBack();
    expect(shown()).toBe("Never stored");
    projects.beginNew({ ...firstMaze, name: "Third" }, null);
    edit("Third, never stored");
    back();
    expect(shown()).toBe("Never stored");
    goBack();
    expect(shown()).toBe("Third, never stored");
  });
});
