/**
 * User actions on projects: open another, create one, delete one and undo the deletion. Connects
 * the project storage, this tab's current project, the workspace and the messages. Opening a
 * project resets the robot, because a run belongs to one project.
 */
import { isSameMaze, type MazeDocument } from "@corridor/maze";
import { isSameProgram, type ProgramDocument } from "@corridor/program";
import type { i18n } from "i18next";
import {
  dismiss,
  dismissOfProject,
  showMessage,
  type ScreenStore,
} from "../screen/screen-store.ts";
import { openProject, type WorkspaceStore } from "../workspace/workspace-store.ts";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";
import { startAutosave, type Autosave } from "./autosave.ts";
import type { CurrentProject } from "./current-project.ts";
import type { Project, ProjectStorage } from "./project-storage.ts";

/** The tasks of lessons and missions. Each belongs to a project. */
interface ProjectTasks {
  hasTask: (project: string) => boolean;
  copyTask: (from: string, to: string) => void;
}

export interface ProjectPorts {
  store: ProjectStorage;
  current: CurrentProject;
  tasks: ProjectTasks;
  workspace: WorkspaceStore;
  screen: ScreenStore;
  simulator: Pick<SimulatorClient, "send">;
  words: Pick<i18n, "t">;
  /** calls a function later, such as `setTimeout` */
  later: (run: () => void, milliseconds: number) => void;
}

export class ProjectService {
  readonly #ports: ProjectPorts;
  readonly autosave: Autosave;
  /** returns from unedited shared projects to the user's own; null without shared ones */
  #ownProject: (() => void) | null = null;

  constructor(ports: ProjectPorts) {
    this.#ports = ports;
    const { screen, words, tasks } = ports;
    this.autosave = startAutosave({
      ...ports,
      onFork: (id) => {
        tasks.copyTask(id, this.currentId());
        showMessage(screen, { tone: "info", text: words.t("projects.forked") });
      },
      onBlocked: () => showMessage(screen, { tone: "bad", text: words.t("projects.blocked") }),
    });
    this.#reportDamaged();
    ports.store.sweepChallenges();
  }

  /** The projects on this device, newest first, including the open one as it is now. */
  list(): Project[] {
    this.autosave.flush();
    this.#reportDamaged();
    return this.#ports.store.list();
  }

  currentId(): string {
    return this.#ports.current.project.id;
  }

  /** How often another project was opened. A copy of the open one is no other project. */
  opened(): number {
    return this.#ports.current.opened;
  }

  /**
   * Opens the newest version of another stored project, after storing the open one. If the open one
   * cannot be stored, a message offers to return to it.
   */
  open(project: Project): void {
    this.#offerUnsaved();
    this.#show(project);
  }

  /**
   * Opens documents as a new project, or the stored project with exactly these documents. Never
   * opens a project of a task: a run from elsewhere must not solve it.
   * @param program null: a copy of the user's own program
   * @param isRobotThere whether the displayed run has these documents
   * @returns a function that returns to the previous project: its newest version, or the edits that
   *   could not be stored
   */
  begin(maze: MazeDocument, program: ProgramDocument | null, isRobotThere = false): () => void {
    this.autosave.flush();
    const { store, tasks, workspace } = this.#ports;
    const own = workspace.getState().program;
    const found = store.list().find(
      (project) =>
        isSameMaze(project.maze, maze) &&
        isSameProgram(project.program, program ?? own) &&
        // A copy for the user's own program is one only until it is edited.
        (program !== null || !project.edited) &&
        !tasks.hasTask(project.id),
    );
    if (found === undefined) return this.beginNew(maze, program, isRobotThere);
    this.#offerUnsaved();
    const back = this.#backAction();
    this.#show(found, isRobotThere);
    return back;
  }

  /**
   * Opens documents as a new project even if another one is equal: for documents that must not
   * become part of the user's own, such as a challenge and its limits.
   * @param program null: a copy of the user's own program
   * @returns a function that returns to the previous project: its newest version, or the edits that
   *   could not be stored
   */
  beginNew(maze: MazeDocument, program: ProgramDocument | null, isRobotThere = false): () => void {
    const { current, workspace } = this.#ports;
    this.#offerUnsaved();
    const back = this.#backAction();
    current.begin(maze, program ?? workspace.getState().program);
    this.#display(current.project.maze, current.project.program, isRobotThere);
    return back;
  }

  /**
   * Returns a function that opens the current project again: its newest version, or the edits that
   * could not be stored.
   */
  backAction(): () => void {
    this.autosave.flush();
    return this.#backAction();
  }

  /** The same after the autosave has just run. */
  #backAction(): () => void {
    const { current, workspace } = this.#ports;
    const { maze, program } = workspace.getState();
    const before = current.project;
    const isSaved = current.has(maze, program);
    return () => {
      if (isSaved) {
        this.open(before);
        return;
      }
      this.#offerUnsaved();
      current.resume(before);
      this.#display(maze, program);
    };
  }

  /** Offers to return to edits that could not be stored when another project opens. */
  #offerUnsaved(): void {
    const { current, workspace, screen, words } = this.#ports;
    this.autosave.flush();
    const { maze, program } = workspace.getState();
    if (current.has(maze, program)) return;
    const back = this.#backAction();
    const id = showMessage(screen, {
      tone: "bad",
      text: words.t("projects.blocked"),
      action: {
        label: words.t("projects.back"),
        run: () => {
          dismiss(screen, id);
          back();
        },
      },
    });
  }

  /**
   * Opens the content of a link. Through a series of links, the returned function always leads to
   * the user's own project, not to a shared one that was not edited.
   * @param program null: a copy of the user's own program
   * @param isRobotThere whether the displayed run has these documents
   */
  beginShared(
    maze: MazeDocument,
    program: ProgramDocument | null,
    isRobotThere = false,
  ): () => void {
    const { current, workspace, tasks } = this.#ports;
    this.autosave.flush();
    const open = workspace.getState();
    const isShared =
      !current.project.edited &&
      current.has(open.maze, open.program) &&
      !tasks.hasTask(this.currentId());
    const home = isShared ? (this.#ownProject ?? this.#backToNewestOwn()) : null;
    const back = this.begin(maze, program, isRobotThere);
    this.#ownProject = home ?? back;
    return this.#ownProject;
  }

  /** Deletes a project that is not open, with a message to undo it. */
  remove(project: Project): void {
    const { store, screen, words } = this.#ports;
    // Another tab may have stored it since it was listed; Undo must restore the deleted version.
    const removed = store.read(project.id) ?? project;
    const challenge = store.remove(project.id);
    const id = showMessage(screen, {
      tone: "info",
      text: words.t("projects.deleted", { name: removed.maze.name }),
      action: {
        label: words.t("projects.undo"),
        run: () => {
          try {
            // A tab that has it open stores a newer version with its next edit.
            if (!store.has(removed.id)) store.write(removed, challenge);
          } catch {
            showMessage(screen, { tone: "bad", text: words.t("projects.blocked") });
          }
          dismiss(screen, id);
        },
      },
    });
  }

  #show(project: Project, isRobotThere = false): void {
    const { maze, program } = this.#ports.current.open(project);
    this.#display(maze, program, isRobotThere);
  }

  #display(maze: MazeDocument, program: ProgramDocument, isRobotThere = false): void {
    const { workspace, simulator, screen } = this.#ports;
    openProject(workspace, maze, program);
    dismissOfProject(screen);
    if (!isRobotThere) simulator.send({ type: "reset" });
  }

  /** After a reload, the user's newest own project is the best guess. */
  #backToNewestOwn(): (() => void) | null {
    const own = this.#ports.store.list().find(({ edited }) => edited);
    return own === undefined ? null : () => this.open(own);
  }

  #reportDamaged(): void {
    const { store, screen, words } = this.#ports;
    for (const { reason } of store.sweep()) {
      showMessage(screen, { tone: "bad", text: words.t("projects.damaged", { reason }) });
    }
  }
}
