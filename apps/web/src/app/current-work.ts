/**
 * The work that this tab has open. Every tab has its own: when another tab saved the same work in
 * the meantime, this tab goes on in a new work, so that both versions stay.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { KeyValueStorage, Work, WorkShelf } from "./works.ts";

/** The tab's own storage lives as long as the tab and survives a reload. */
const CURRENT_KEY = "corridor.current";

export interface CurrentWorkPorts {
  shelf: WorkShelf;
  /** sessionStorage */
  tab: KeyValueStorage;
  /** milliseconds since 1970 */
  now: () => number;
  newId: () => string;
}

export class CurrentWork {
  readonly #ports: CurrentWorkPorts;
  #work: Work;
  /** the revision of this work on the shelf when this tab last read or wrote it; null: never there */
  #known: string | null = null;

  /**
   * Opens the tab's own work, else the newest, else a new one made of the given documents (which is
   * stored when it is first edited).
   */
  constructor(ports: CurrentWorkPorts, firstMaze: MazeDocument, firstProgram: ProgramDocument) {
    this.#ports = ports;
    const id = ports.tab.getItem(CURRENT_KEY);
    const stored = (id === null ? null : ports.shelf.read(id)) ?? ports.shelf.list()[0];
    this.#work = stored ?? this.#newWork(firstMaze, firstProgram);
    if (stored !== undefined) this.open(stored);
  }

  /** The work as it was last opened or saved. */
  get work(): Work {
    return this.#work;
  }

  /** Whether these very documents were already saved or opened: nothing to do. */
  has(maze: MazeDocument, program: ProgramDocument): boolean {
    return this.#work.maze === maze && this.#work.program === program;
  }

  /**
   * Stores an edit of the work.
   * @returns "forked" when another tab had saved the work since, so that this is a new one now
   * @throws what the storage throws when it is full or forbidden
   */
  save(maze: MazeDocument, program: ProgramDocument): "saved" | "forked" {
    const { shelf, now, newId } = this.#ports;
    const stored = shelf.read(this.#work.id);
    const isForked = stored !== null && stored.revision !== this.#known;
    const work: Work = {
      id: isForked ? newId() : this.#work.id,
      savedAt: now(),
      revision: newId(),
      edited: true,
      maze,
      program,
    };
    shelf.write(work);
    this.#hold(work, work.revision);
    return isForked ? "forked" : "saved";
  }

  /** Makes another work of the shelf, or one taken from it, the work of this tab. */
  open(work: Work): void {
    this.#hold(work, this.#ports.shelf.read(work.id)?.revision ?? null);
  }

  /**
   * Makes documents that came from elsewhere (a link, an empty maze) a new work of this tab. It is
   * put on the shelf at once if there is room; if not, the next save reports it.
   */
  begin(maze: MazeDocument, program: ProgramDocument): void {
    const work = this.#newWork(maze, program);
    try {
      this.#ports.shelf.write(work);
    } catch {
      // The work is open all the same, and the next edit is reported as not kept.
    }
    this.open(work);
  }

  #newWork(maze: MazeDocument, program: ProgramDocument): Work {
    const { newId, now } = this.#ports;
    return { id: newId(), savedAt: now(), revision: newId(), edited: false, maze, program };
  }

  #hold(work: Work, known: string | null): void {
    this.#work = work;
    this.#known = known;
    try {
      this.#ports.tab.setItem(CURRENT_KEY, work.id);
    } catch {
      // A reload then opens the newest work, which is this one in all likelihood.
    }
  }
}
