/** The class that this tab has joined. Its parts load only if there is one. */
import { createStore } from "zustand/vanilla";
import type { StudentClass } from "./student-class.ts";

export function createClassStore() {
  return createStore<{ joined: StudentClass | null }>()(() => ({ joined: null }));
}
export type ClassStore = ReturnType<typeof createClassStore>;
