/** The class that this tab has joined, if any, and its parts of the screen, which load with it. */
import type { ComponentType } from "react";
import { createStore } from "zustand/vanilla";
import type { StudentClass } from "./student-class.ts";

interface ClassOnScreen {
  joined: StudentClass;
  /** in the bar */
  Menu: ClassPart;
  /** below the bar, during a pause */
  Band: ClassPart;
}

type ClassPart = ComponentType<{ joined: StudentClass }>;

interface ClassState {
  /** null: this tab has joined no class */
  shown: ClassOnScreen | null;
  /** whether the teacher has paused the class: the robot stands still, and nobody edits */
  isPaused: boolean;
}

export function createClassStore() {
  return createStore<ClassState>()(() => ({ shown: null, isPaused: false }));
}
export type ClassStore = ReturnType<typeof createClassStore>;
