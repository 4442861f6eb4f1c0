/**
 * Saves every edit: within 300 ms, and at once when the page is hidden or left. Says on the screen
 * whether the newest edit is safe.
 */
import type { ScreenStore } from "../stores/screen-store.ts";
import type { WorkspaceStore } from "../stores/workspace-store.ts";
import type { CurrentWork } from "./current-work.ts";

/** The first of several quick edits starts the clock, so that long strokes are saved too. */
const SAVE_AFTER_MS = 250;

export interface AutosavePorts {
  current: CurrentWork;
  workspace: WorkspaceStore;
  screen: ScreenStore;
  /** runs a function later, such as `setTimeout` */
  later: (run: () => void, milliseconds: number) => void;
  /** another tab had changed the work: this tab's version is a work of its own now */
  onFork: () => void;
  /** the storage refused, for the first time since it last took something */
  onBlocked: () => void;
}

export interface Autosave {
  /** saves now what is not saved yet */
  flush: () => void;
}

/** Starts to watch the workspace. */
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
      const outcome = current.save(maze, program);
      screen.setState({ saved: "saved" });
      if (outcome === "forked") ports.onFork();
    } catch {
      const wasBlocked = screen.getState().saved === "blocked";
      screen.setState({ saved: "blocked" });
      if (!wasBlocked) ports.onBlocked();
    }
  }

  workspace.subscribe(({ maze, program }) => {
    if (current.has(maze, program) || isScheduled) return;
    isScheduled = true;
    // A refusal stays in sight until something could be saved again.
    if (screen.getState().saved === "saved") screen.setState({ saved: "saving" });
    ports.later(() => {
      isScheduled = false;
      flush();
    }, SAVE_AFTER_MS);
  });
  return { flush };
}

/** As much of the window and its document as tells that the page goes out of sight. */
export interface PageLife {
  listen: (type: "pagehide" | "visibilitychange", listener: () => void) => void;
  isHidden: () => boolean;
}

/** Saves when the page may not come back: some browsers end a hidden page without a word. */
export function flushWhenHidden(autosave: Autosave, page: PageLife): void {
  page.listen("pagehide", autosave.flush);
  page.listen("visibilitychange", () => {
    if (page.isHidden()) autosave.flush();
  });
}
