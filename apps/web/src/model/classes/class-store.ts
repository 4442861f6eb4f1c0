/** The class that this tab has joined. Its parts load only if there is one. */
import { createStore } from "zustand/vanilla";
import type { StudentClass } from "./student-class.ts";

interface ClassState {
  /** null: none */
  joined: StudentClass | null;
  /** whether the teacher has paused the class: the robot stands still, and nobody edits */
  isPaused: boolean;
}

export function createClassStore() {
  return createStore<ClassState>()(() => ({ joined: null, isPaused: false }));
}
export type ClassStore = ReturnType<typeof createClassStore>;
