/**
 * The open project of this tab. Every tab has its own: if another tab stored the same project in
 * the meantime, this tab continues in a new project, so that both versions remain.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Project, ProjectStorage } from "./project-storage.ts";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";

/** sessionStorage lives as long as the tab and survives a reload. */
const CURRENT_KEY = "corridor.current";

export interface CurrentProjectPorts {
  store: ProjectStorage;
  /** sessionStorage */
  tab: KeyValueStorage;
  /** milliseconds since 1970 */
  now: () => number;
  newId: () => string;
}

export class CurrentProject {
  readonly #ports: CurrentProjectPorts;
  #opened = 0;
  /** as this tab last read or wrote it; another stored revision comes from another tab */
  #project: Project;

  /**
   * Opens the tab's own project, or the newest one, or a new one with the given documents, which is
   * stored with its first edit.
   */
  constructor(ports: CurrentProjectPorts, firstMaze: MazeDocument, firstProgram: ProgramDocument) {
    this.#ports = ports;
    const id = ports.tab.getItem(CURRENT_KEY);
    const stored = (id === null ? null : ports.store.read(id)) ?? ports.store.list()[0];
    this.#project = stored ?? this.#newProject(firstMaze, firstProgram);
    if (stored !== undefined) this.#setCurrent(stored);
  }

  /** The project as it was last opened or stored. */
  get project(): Project {
    return this.#project;
  }

  /** How often another project was opened. A copy after a fork continues the same project. */
  get opened(): number {
    return this.#opened;
  }

  /** Whether exactly these documents are already stored or were opened. */
  has(maze: MazeDocument, program: ProgramDocument): boolean {
    return this.#project.maze === maze && this.#project.program === program;
  }

  /**
   * Stores an edit of the project.
   * @returns the id until now if another tab had stored the project since, or its entry was damaged;
   *   the project is a new one then. Otherwise null
   * @throws the error of the storage if it is full or forbidden
   */
  save(maze: MazeDocument, program: ProgramDocument): string | null {
    const { store, now, newId } = this.#ports;
    const { id } = this.#project;
    const isForked = !store.canOverwrite(this.#project);
    const project: Project = {
      id: isForked ? newId() : id,
      savedAt: now(),
      revision: newId(),
      edited: true,
      maze,
      program,
    };
    store.write(project);
    this.#setCurrent(project);
    return isForked ? id : null;
  }

  /**
   * Opens another stored project in this tab, in its newest version: another tab may have stored it
   * since it was listed. A project that was deleted meanwhile is opened as it was listed.
   * @returns the project that is open now
   */
  open(listed: Project): Project {
    const newest = this.#ports.store.read(listed.id) ?? listed;
    this.#open(newest);
    return newest;
  }

  /**
   * Returns to an earlier version of a project, for edits that could not be stored. If another tab
   * stored the project since, the next write forks it.
   */
  resume(known: Project): void {
    this.#open(known);
  }

  /**
   * Opens documents from elsewhere (a link, an empty maze) as a new project of this tab. It is
   * stored at once if there is room; otherwise the next write reports the error.
   */
  begin(maze: MazeDocument, program: ProgramDocument): void {
    const project = this.#newProject(maze, program);
    try {
      this.#ports.store.write(project);
    } catch {
      // The project is open all the same, and the next edit reports the error.
    }
    this.#open(project);
  }

  #open(project: Project): void {
    if (project.id !== this.#project.id) this.#opened++;
    this.#setCurrent(project);
  }

  #newProject(maze: MazeDocument, program: ProgramDocument): Project {
    const { newId, now } = this.#ports;
    return { id: newId(), savedAt: now(), revision: newId(), edited: false, maze, program };
  }

  #setCurrent(project: Project): void {
    this.#project = project;
    try {
      this.#ports.tab.setItem(CURRENT_KEY, project.id);
    } catch {
      // A reload then opens the newest project, which is most likely this one.
    }
  }
}
