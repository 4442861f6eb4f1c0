/** The class that this tab has joined, if any, and its parts of the screen, which load with it. */
import type { ComponentType } from "react";
import { createStore } from "zustand/vanilla";
import type { StudentClass } from "./student-class.ts";

interface ClassOnScreen {
  joined: StudentClass;
  /** in the bar */
  Menu: ComponentType<{ joined: StudentClass }>;
  /** below the bar, during a pause */
  Band: ComponentType<{ endsAt: number }>;
}

interface ClassState {
  /** null: this tab has joined no class */
  shown: ClassOnScreen | null;
  /**
   * end of the pause, in milliseconds since 1970: until then the robot stands still, and nobody
   * edits; null: the teacher has not paused the class
   */
  pauseEndsAt: number | null;
}

export function createClassStore() {
  return createStore<ClassState>()(() => ({ shown: null, pauseEndsAt: null }));
}
export type ClassStore = ReturnType<typeof createClassStore>;

/** Whether the teacher has paused the class of this tab. */
export function isPaused(classes: Pick<ClassStore, "getState">): boolean {
  return classes.getState().pauseEndsAt !== null;
}
