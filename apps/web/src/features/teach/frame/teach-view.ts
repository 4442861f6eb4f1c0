/**
 * The view of `/teach` that an address names by its fragment. A fragment without a name is the link
 * of a lesson, which opens in the editor.
 */
import { REPORT_HASH } from "../../../model/teaching/saved-reports.ts";

export type TeachView =
  | { name: "home" | "make" }
  /** `report`: id of the saved report to open; null for the list */
  | { name: "report"; report: string | null }
  /** `lesson`: id of the saved lesson to check; null for the one that was checked last */
  | { name: "hand-ins"; lesson: string | null }
  /** a saved lesson in the editor */
  | { name: "lesson"; id: string }
  | { name: "link"; link: string };

export const MAKE_HASH = "#make";
export const HAND_INS_HASH = "#hand-ins";
const LESSON_HASH = "#lesson=";

/** The address of a saved lesson in the editor. */
export function lessonHash(id: string): string {
  return LESSON_HASH + id;
}

/** The address of the hand-ins of a saved lesson. */
export function handInsHash(id: string): string {
  return `${HAND_INS_HASH}=${id}`;
}

export function teachViewOf(hash: string): TeachView {
  if (hash === "" || hash === "#") return { name: "home" };
  if (hash === MAKE_HASH) return { name: "make" };
  if (hash === REPORT_HASH) return { name: "report", report: null };
  if (hash.startsWith(`${REPORT_HASH}=`)) {
    return { name: "report", report: hash.slice(REPORT_HASH.length + 1) };
  }
  if (hash === HAND_INS_HASH) return { name: "hand-ins", lesson: null };
  if (hash.startsWith(handInsHash(""))) {
    return { name: "hand-ins", lesson: hash.slice(handInsHash("").length) };
  }
  if (hash.startsWith(LESSON_HASH)) return { name: "lesson", id: hash.slice(LESSON_HASH.length) };
  return { name: "link", link: hash.slice(1) };
}
