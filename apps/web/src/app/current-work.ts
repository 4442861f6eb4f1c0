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
  /** as this tab last read or wrote it: another revision on the shelf was saved by another tab */
  #work: Work;

  /**
   * Opens the tab's own work, else the newest, else a new one made of the given documents (which is
   * stored when it is first edited).
   */
  constructor(ports: CurrentWorkPorts, firstMaze: MazeDocument, firstProgram: ProgramDocument) {
    this.#ports = ports;
    const id = ports.tab.getItem(CURRENT_KEY);
    const stored = (id === null ? null : ports.shelf.read(id)) ?? ports.shelf.list()[0];
    this.#work = stored ?? this.#newWork(firstMaze, firstProgram);
    if (stored !== undefined) this.#hold(stored);
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
   * @returns "forked" when another tab had saved the work since, or its entry was damaged, so that
   *   this is a new one now
   * @throws what the storage throws when it is full or forbidden
   */
  save(maze: MazeDocument, program: ProgramDocument): "saved" | "forked" {
    const { shelf, now, newId } = this.#ports;
    const isForked = !shelf.mayWriteOver(this.#work);
    const work: Work = {
      id: isForked ? newId() : this.#work.id,
      savedAt: now(),
      revision: newId(),
      edited: true,
      maze,
      program,
    };
    shelf.write(work);
    this.#hold(work);
    return isForked ? "forked" : "saved";
  }

  /**
   * Makes another work of the shelf the work of this tab, as it stands there now: another tab may
   * have saved it since it was listed. One that is no longer there is opened as it was listed.
   * @returns the work that is open now, which is the one to show
   */
  open(listed: Work): Work {
    const newest = this.#ports.shelf.read(listed.id) ?? listed;
    this.#hold(newest);
    return newest;
  }

  /**
   * Goes back to a work as this tab knew it, for edits that could not be saved. If another tab saved
   * the work since, the next save makes them a new one.
   */
  resume(known: Work): void {
    this.#hold(known);
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
    this.#hold(work);
  }

  #newWork(maze: MazeDocument, program: ProgramDocument): Work {
    const { newId, now } = this.#ports;
    return { id: newId(), savedAt: now(), revision: newId(), edited: false, maze, program };
  }

  #hold(work: Work): void {
    this.#work = work;
    try {
      this.#ports.tab.setItem(CURRENT_KEY, work.id);
    } catch {
      // A reload then opens the newest work, which is this one in all likelihood.
    }
  }
}
