import { describe, expect, it } from "vitest";
import { noChallenge, openTask } from "../challenge/challenge-store.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { setMaze, setProgram, undo } from "../workspace/workspace-store.ts";
import { LessonsNavigation } from "./lessons-navigation.ts";
import { lines } from "./missions/mission.ts";
import { sampleLesson, sampleTask } from "./testing/sample-lesson.ts";
import { StoredLessons } from "./stored-lessons.ts";
import { lessonsPage, noAddressBar } from "./testing/lessons-page.ts";

function openPage() {
  const page = lessonsPage();
  /** index of each maze whose run is judged */
  const judged: number[] = [];
  const attempt = { begin: (_challenge: unknown, maze: number) => void judged.push(maze) };
  const navigation = new LessonsNavigation(
    page.ports,
    attempt,
    new StoredLessons(page.device),
    noAddressBar,
  );
  return { ...page, navigation, judged };
}

describe("navigation between missions", () => {
  it("opens each mission in a project of its own, and later where the student left it", () => {
    const { navigation, challenge, workspace, ports } = openPage();
    expect(navigation.openMission("one-line")).toBe(true);
    expect(challenge.getState().mission).toBe("one-line");
    const project = ports.projects.currentId();
    navigation.openMission("every-maze");
    expect(ports.projects.currentId()).not.toBe(project);
    navigation.openMission("one-line");
    expect(ports.projects.currentId()).toBe(project);
    expect(workspace.getState().maze).toEqual(openTask(challenge.getState())?.mazes[0]);
  });

  it("opens nothing for an unknown mission", () => {
    const { navigation, challenge } = openPage();
    expect(navigation.follow("no-such-mission")).toBe(false);
    expect(challenge.getState().lesson).toBeNull();
  });

  it("returns to what was open before the first mission", () => {
    const { navigation, workspace, ports, sent } = openPage();
    navigation.openMission("one-line");
    navigation.openMission("every-maze");
    navigation.goHome();
    expect(ports.projects.currentId()).toBe("own");
    expect(workspace.getState()).toMatchObject({ maze: firstMaze, program: firstProgram });
    expect(sent.at(-1)).toEqual({ type: "driver", driver: "program" });
  });

  it("shows another maze of the challenge with the same program", () => {
    const { navigation, challenge, workspace, judged } = openPage();
    navigation.openMission("every-maze");
    const program = lines("reverse");
    setProgram(workspace, program);
    navigation.showMaze(1);
    expect(challenge.getState().maze).toBe(1);
    expect(workspace.getState().program).toEqual(program);
    expect(judged).toEqual([0, 1]);
  });

  it("does not return to the previous maze by Undo, which reverts only edits", () => {
    const { navigation, challenge, workspace } = openPage();
    navigation.openMission("every-maze");
    const { program } = workspace.getState();
    setProgram(workspace, lines("reverse"));
    navigation.showMaze(1);
    undo(workspace);
    expect(workspace.getState().program).toEqual(program);
    expect(challenge.getState().maze).toBe(1);
    expect(workspace.temporal.getState().pastStates).toEqual([]);
  });

  it("ends the run where Undo returns to the previous maze of an editable task", () => {
    const { navigation, challenge, workspace, sent } = openPage();
    const every = sampleTask("every-maze", "Mine");
    const task = { ...every, allowed: { ...every.allowed, maze: true } };
    navigation.openShared({ ...sampleLesson, tasks: [task] }, null);
    navigation.showMaze(1);
    sent.length = 0;
    undo(workspace);
    expect(challenge.getState().maze).toBe(0);
    expect(sent).toEqual([{ type: "reset" }]);
  });

  it("continues in the copy of a project that another tab has stored", () => {
    const { navigation, challenge, fork } = openPage();
    navigation.openMission("every-maze");
    fork();
    navigation.showMaze(1);
    expect(challenge.getState().maze).toBe(1);
  });

  it("closes a challenge whose maze the student replaces, and says so", () => {
    const { navigation, challenge, workspace, storage, messages } = openPage();
    navigation.openMission("one-line");
    setMaze(workspace, { ...firstMaze, name: "Mine" });
    expect(challenge.getState().lesson).toBeNull();
    expect(storage.record.works).toEqual({});
    expect(messages()).toMatchObject([{ text: "missions:card.replaced" }]);
  });

  it("resumes a lesson of one task where the student left it", () => {
    const { navigation, challenge, ports } = openPage();
    const [task] = sampleLesson.tasks;
    const lesson = { ...sampleLesson, tasks: task === undefined ? [] : [task] };
    navigation.resume(lesson);
    const project = ports.projects.currentId();
    navigation.goHome();
    navigation.resume(lesson);
    expect(ports.projects.currentId()).toBe(project);
    expect(challenge.getState().lesson).toEqual(lesson);
  });

  it("stores a shared challenge with its project, and loads it with the project", () => {
    const { navigation, challenge, ports } = openPage();
    navigation.openMission("every-maze");
    const shared = challenge.getState().lesson;
    if (shared === null) throw new Error("no challenge");
    navigation.openShared(shared, null);
    const project = ports.projects.list().at(-1);
    navigation.goHome();
    if (project !== undefined) ports.projects.open(project);
    navigation.sync();
    expect(challenge.getState()).toMatchObject({ lesson: shared, mission: null });
  });
});

describe("navigation between the tasks of a lesson", () => {
  function openLesson(lesson = sampleLesson) {
    const page = openPage();
    page.navigation.openShared(lesson, null);
    return { ...page, id: page.challenge.getState().lessonId ?? "" };
  }

  it("opens each task in a project of its own, and later where the student left it", () => {
    const { navigation, challenge, workspace, ports } = openLesson();
    expect(challenge.getState()).toMatchObject({ index: 0, mission: null });
    const project = ports.projects.currentId();
    navigation.openTask(1);
    expect(challenge.getState().index).toBe(1);
    expect(ports.projects.currentId()).not.toBe(project);
    expect(workspace.getState().maze).toEqual(sampleLesson.tasks[1]?.mazes[0]);
    navigation.openTask(0);
    expect(ports.projects.currentId()).toBe(project);
  });

  it("loads the task of a project again, as after a reload", () => {
    const { navigation, challenge, id } = openLesson();
    navigation.openTask(2);
    challenge.setState(noChallenge);
    navigation.sync();
    expect(challenge.getState()).toMatchObject({ lesson: sampleLesson, index: 2, lessonId: id });
  });

  it("continues a lesson that opens again at its first unsolved task", () => {
    const { navigation, challenge, device, ports, id } = openLesson();
    const projects = ports.projects.list().length;
    new StoredLessons(device).addSolved({ lesson: id, index: 0 });
    navigation.goHome();
    navigation.openShared(sampleLesson, null);
    expect(challenge.getState()).toMatchObject({ index: 1, solved: [true, false, false] });
    expect(ports.projects.list()).toHaveLength(projects + 1);
  });

  it("opens no locked task", () => {
    const { navigation, challenge } = openLesson({ ...sampleLesson, order: "in turn" });
    navigation.openTask(1);
    expect(challenge.getState().index).toBe(0);
    challenge.setState({ solved: [true, false, false] });
    navigation.openTask(1);
    expect(challenge.getState().index).toBe(1);
  });

  it("leads back to a task that another maze closed, without the other maze", () => {
    const { navigation, challenge, workspace, messages } = openLesson();
    navigation.openTask(1);
    setMaze(workspace, { ...firstMaze, name: "Mine" });
    expect(challenge.getState().lesson).toBeNull();
    messages()[0]?.action?.run();
    expect(challenge.getState()).toMatchObject({ lesson: sampleLesson, index: 1 });
    expect(messages()).toEqual([]);
  });

  it("hands control to a driver that the task allows, and resets what it hides", () => {
    const [task] = sampleLesson.tasks;
    if (task === undefined) throw new Error("no task");
    const allowed = { ...task.allowed, drivers: ["remote" as const, "me" as const], tools: [] };
    const { navigation, ports, sent } = openPage();
    ports.screen.setState({ tool: "measure" });
    ports.run.setState({ speed: "max" });
    navigation.openShared({ ...sampleLesson, tasks: [{ ...task, allowed }] }, null);
    expect(sent).toContainEqual({ type: "driver", driver: "me" });
    expect(sent).toContainEqual({ type: "speed", speed: 1 });
    expect(ports.screen.getState().tool).toBe("blocks");
  });
});
