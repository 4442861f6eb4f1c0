/**
 * What the reader does with works: open another, begin a new one, delete one and take that back.
 * Joins the shelf, this tab's current work, the documents on the screen and the messages. Whatever
 * opens, the robot goes to its start: the run of one work is none of another's.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { i18n } from "i18next";
import {
  dismiss,
  dismissOfProject,
  showMessage,
  type ScreenStore,
} from "../stores/screen-store.ts";
import { openProject, type WorkspaceStore } from "../stores/workspace-store.ts";
import type { SimulatorClient } from "../worker/simulator-client.ts";
import { startAutosave, type Autosave } from "./autosave.ts";
import type { CurrentWork } from "./current-work.ts";
import type { Work, WorkShelf } from "./works.ts";

export interface WorksPorts {
  shelf: WorkShelf;
  current: CurrentWork;
  workspace: WorkspaceStore;
  screen: ScreenStore;
  simulator: Pick<SimulatorClient, "send">;
  words: Pick<i18n, "t">;
  /** runs a function later, such as `setTimeout` */
  later: (run: () => void, milliseconds: number) => void;
}

export class WorksService {
  readonly #ports: WorksPorts;
  readonly autosave: Autosave;
  /** leads from the shared works that are only looked at to what the reader had open before them */
  #home: (() => void) | null = null;

  constructor(ports: WorksPorts) {
    this.#ports = ports;
    const { screen, words } = ports;
    this.autosave = startAutosave({
      ...ports,
      onFork: () => showMessage(screen, { tone: "info", text: words.t("works.forked") }),
      onBlocked: () => showMessage(screen, { tone: "bad", text: words.t("works.blocked") }),
    });
    this.#tellDamage();
    ports.shelf.sweepChallenges();
  }

  /** The works on this device, newest first, with the one that is open as it is now. */
  list(): Work[] {
    this.autosave.flush();
    this.#tellDamage();
    return this.#ports.shelf.list();
  }

  currentId(): string {
    return this.#ports.current.work.id;
  }

  /**
   * Opens another work of the shelf in its newest version; what is open is saved first. Where it cannot
   * be saved, a message leads back to it.
   */
  open(work: Work): void {
    this.#offerUnsaved();
    this.#show(work);
  }

  /**
   * Opens documents as a new work, or the work of the shelf that already holds exactly them.
   * @param program null: the reader's own program is copied along, whatever it is
   * @param isRobotThere whether the run on the screen is one of these very documents
   * @returns a way back to what was open: its newest version, or the edits that could not be saved
   */
  begin(maze: MazeDocument, program: ProgramDocument | null, isRobotThere = false): () => void {
    this.autosave.flush();
    const found = this.#ports.shelf.list().find((work) => isCopy(work, maze, program));
    if (found === undefined) return this.beginNew(maze, program, isRobotThere);
    this.#offerUnsaved();
    const back = this.#wayBack();
    this.#show(found, isRobotThere);
    return back;
  }

  /**
   * Opens documents as a new work, also where another one holds the same: for what must not become part
   * of the reader's own, such as a challenge and its limits.
   * @param program null: the reader's own program is copied along, whatever it is
   * @returns a way back to what was open: its newest version, or the edits that could not be saved
   */
  beginNew(maze: MazeDocument, program: ProgramDocument | null, isRobotThere = false): () => void {
    const { current, workspace } = this.#ports;
    this.#offerUnsaved();
    const back = this.#wayBack();
    current.begin(maze, program ?? workspace.getState().program);
    this.#put(current.work.maze, current.work.program, isRobotThere);
    return back;
  }

  /** A way back to what is open: its newest version, or the edits that could not be saved. */
  wayBack(): () => void {
    this.autosave.flush();
    return this.#wayBack();
  }

  /** To what is open, which the autosave has just tried to save. */
  #wayBack(): () => void {
    const { current, workspace } = this.#ports;
    const { maze, program } = workspace.getState();
    const before = current.work;
    const isKept = current.has(maze, program);
    return () => {
      if (isKept) {
        this.open(before);
        return;
      }
      this.#offerUnsaved();
      current.resume(before);
      this.#put(maze, program);
    };
  }

  /** Whatever could not be saved is not lost when something else opens. */
  #offerUnsaved(): void {
    const { current, workspace, screen, words } = this.#ports;
    this.autosave.flush();
    const { maze, program } = workspace.getState();
    if (current.has(maze, program)) return;
    const back = this.#wayBack();
    const id = showMessage(screen, {
      tone: "bad",
      text: words.t("works.blocked"),
      action: {
        label: words.t("works.back"),
        run: () => {
          dismiss(screen, id);
          back();
        },
      },
    });
  }

  /**
   * Opens what a link brought. From one link to the next the way back stays the same: to the reader's
   * own work, not to the shared one that was only looked at.
   * @param program null: the reader's own program is copied along
   * @param isRobotThere whether the run on the screen is one of these very documents
   */
  beginShared(
    maze: MazeDocument,
    program: ProgramDocument | null,
    isRobotThere = false,
  ): () => void {
    const { current, workspace } = this.#ports;
    this.autosave.flush();
    const open = workspace.getState();
    const isOnlyLooking = !current.work.edited && current.has(open.maze, open.program);
    const home = isOnlyLooking ? (this.#home ?? this.#wayToNewestOwn()) : null;
    const back = this.begin(maze, program, isRobotThere);
    this.#home = home ?? back;
    return this.#home;
  }

  /** Deletes a work that is not open, with a message that takes it back. */
  remove(work: Work): void {
    const { shelf, screen, words } = this.#ports;
    // Another tab may have saved it since it was listed, and what is taken back must be what went.
    const removed = shelf.read(work.id) ?? work;
    const challenge = shelf.remove(work.id);
    const id = showMessage(screen, {
      tone: "info",
      text: words.t("works.deleted", { name: removed.maze.name }),
      action: {
        label: words.t("works.undo"),
        run: () => {
          try {
            // A tab that has it open stores it again with its next edit, which is newer.
            if (!shelf.has(removed.id)) shelf.write(removed, challenge);
          } catch {
            showMessage(screen, { tone: "bad", text: words.t("works.blocked") });
          }
          dismiss(screen, id);
        },
      },
    });
  }

  #show(work: Work, isRobotThere = false): void {
    const { maze, program } = this.#ports.current.open(work);
    this.#put(maze, program, isRobotThere);
  }

  #put(maze: MazeDocument, program: ProgramDocument, isRobotThere = false): void {
    const { workspace, simulator, screen } = this.#ports;
    openProject(workspace, maze, program);
    dismissOfProject(screen);
    if (!isRobotThere) simulator.send({ type: "reset" });
  }

  /** After a reload nothing else tells which work the reader came from. */
  #wayToNewestOwn(): (() => void) | null {
    const own = this.#ports.shelf.list().find(({ edited }) => edited);
    return own === undefined ? null : () => this.open(own);
  }

  #tellDamage(): void {
    const { shelf, screen, words } = this.#ports;
    for (const { reason } of shelf.sweep()) {
      showMessage(screen, { tone: "bad", text: words.t("works.damaged", { reason }) });
    }
  }
}

/** Whether a work is the very thing that is being opened, so that it need not be made again. */
function isCopy(work: Work, maze: MazeDocument, program: ProgramDocument | null): boolean {
  if (!isSame(work.maze, maze)) return false;
  return program === null ? !work.edited : isSame(work.program, program);
}

/** Parsed documents have their fields in the order of the schema, so their texts can be compared. */
function isSame(a: unknown, b: unknown): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
