/**
 * Stores every edit: within 300 ms, and at once when the page is hidden or left. Reports whether
 * the newest edit is stored.
 */
import type { ScreenStore } from "../screen/screen-store.ts";
import type { WorkspaceStore } from "../workspace/workspace-store.ts";
import type { CurrentProject } from "./current-project.ts";

/** The first of several quick edits starts the timer, so that long strokes are stored, too. */
const SAVE_AFTER_MS = 250;

export interface AutosavePorts {
  current: CurrentProject;
  workspace: WorkspaceStore;
  screen: ScreenStore;
  /** calls a function later, such as `setTimeout` */
  later: (run: () => void, milliseconds: number) => void;
  /** another tab had changed the project of this id: this tab's version is a new project now */
  onFork: (id: string) => void;
  /** the storage refused a write for the first time since the last successful one */
  onBlocked: () => void;
}

export interface Autosave {
  /** stores pending edits now */
  flush: () => void;
}

/** Starts to observe the workspace. */
export function startAutosave(ports: AutosavePorts): Autosave {
  const { current, workspace, screen } = ports;
  let isScheduled = false;

  function flush(): void {
    const { maze, program } = workspace.getState();
    if (current.has(maze, program)) {
      if (screen.getState().saved === "saving") screen.setState({ saved: "saved" });
      return;
    }
    try {
      const forked = current.save(maze, program);
      screen.setState({ saved: "saved" });
      if (forked !== null) ports.onFork(forked);
    } catch {
      const wasBlocked = screen.getState().saved === "blocked";
      screen.setState({ saved: "blocked" });
      if (!wasBlocked) ports.onBlocked();
    }
  }

  workspace.subscribe(({ maze, program }) => {
    if (current.has(maze, program) || isScheduled) return;
    isScheduled = true;
    // A refusal stays visible until a write succeeds.
    if (screen.getState().saved === "saved") screen.setState({ saved: "saving" });
    ports.later(() => {
      isScheduled = false;
      flush();
    }, SAVE_AFTER_MS);
  });
  return { flush };
}

/** The parts of window and document that report that the page is hidden. */
export interface PageLife {
  listen: (type: "pagehide" | "visibilitychange", listener: () => void) => void;
  isHidden: () => boolean;
}

/**
 * Stores edits when the page may not come back: some browsers end a hidden page without an event.
 */
export function flushWhenHidden(autosave: Autosave, page: PageLife): void {
  page.listen("pagehide", autosave.flush);
  page.listen("visibilitychange", () => {
    if (page.isHidden()) autosave.flush();
  });
}
