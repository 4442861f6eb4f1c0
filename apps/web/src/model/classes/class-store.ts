/** What the class of this tab shows on the student's page. Its code loads with it. */
import type { ReactNode } from "react";
import { createStore } from "zustand/vanilla";

interface ClassState {
  /** the class menu in the bar; null: this tab has joined no class */
  menu: ReactNode;
  /**
   * the band of a pause. While there is one, the robot stands still and nobody edits; null: the
   * class is not paused
   */
  pause: ReactNode;
  /** asks the teacher for help, in the card of the task; absent: this tab has joined no class */
  help?: ((look: "full" | "slim") => ReactNode) | undefined;
  /** Called when the student opens a hint of the open task, by its number. */
  onHint?: ((hint: number) => void) | undefined;
}

export function createClassStore() {
  return createStore<ClassState>()(() => ({ menu: null, pause: null }));
}
export type ClassStore = ReturnType<typeof createClassStore>;

/** Whether the teacher has paused the class of this tab. */
export function isPaused(classes: Pick<ClassStore, "getState">): boolean {
  return classes.getState().pause !== null;
}
