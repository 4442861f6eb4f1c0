/** What the page provides to the lessons, for tests: stores, projects in memory, and a simulator. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { createChallengeStore } from "../../challenge/challenge-store.ts";
import { createRunStore } from "../../run/run-store.ts";
import { createScreenStore } from "../../screen/screen-store.ts";
import { MemoryStorage } from "../../storage/testing/memory-storage.ts";
import { createWorkspaceStore, openProject } from "../../workspace/workspace-store.ts";
import { firstMaze, firstProgram } from "../../../simulator/protocol/first-project.ts";
import type { FromWorker } from "../../../simulator/protocol/worker-messages.ts";
import type { LessonsPorts } from "../lessons-ports.ts";
import { LessonsStorage } from "../lessons-storage.ts";

type ToWorker = Parameters<LessonsPorts["simulator"]["send"]>[0];

interface TestProject {
  id: string;
  maze: MazeDocument;
  program: ProgramDocument;
}

/** Texts are their keys, and lists are empty. The open project is the student's own. */
export function lessonsPage() {
  const challenge = createChallengeStore();
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  const screen = createScreenStore();
  const run = createRunStore();
  const device = new MemoryStorage();
  const storage = new LessonsStorage(device);
  const sent: ToWorker[] = [];
  const listeners: ((message: FromWorker) => void)[] = [];
  let current: TestProject = { id: "own", maze: firstMaze, program: firstProgram };
  const projects = [current];
  let opened = 0;
  const open = (project: TestProject): void => {
    if (project.id !== current.id) opened++;
    current = project;
    openProject(workspace, project.maze, project.program);
  };
  const begin = (maze: MazeDocument, program: ProgramDocument | null): (() => void) => {
    const before = current;
    const project = { id: `project-${projects.length}`, maze, program: program ?? firstProgram };
    projects.push(project);
    open(project);
    return () => open(before);
  };
  const ports = {
    challenge,
    workspace,
    storage,
    screen,
    run,
    device,
    words: {
      t: (key: string, options?: { returnObjects: true }) => (options === undefined ? key : []),
      loadNamespaces: () => Promise.resolve(),
    },
    projects: {
      begin,
      beginNew: begin,
      open,
      backAction: () => {
        const before = current;
        return () => open(before);
      },
      currentId: () => current.id,
      opened: () => opened,
      list: () => projects,
    },
    simulator: {
      send: (message: ToWorker) => void sent.push(message),
      listen: (listener: (message: FromWorker) => void) => {
        listeners.push(listener);
        return () => undefined;
      },
    },
  } as unknown as LessonsPorts;
  return {
    ports,
    challenge,
    workspace,
    storage,
    device,
    sent,
    /** A message of the worker. */
    report: (message: FromWorker) => {
      for (const listener of listeners) listener(message);
    },
    /** Another tab has stored the project: the open one is a copy now. */
    fork: () => {
      current = { ...current, id: `${current.id}-copy` };
    },
    messages: () => screen.getState().messages,
  };
}

/** An address bar that stores nothing. */
export const noAddressBar = {
  location: { pathname: "/", search: "", hash: "" },
  history: { pushState: () => undefined, replaceState: () => undefined, state: null },
  onMove: () => undefined,
};
