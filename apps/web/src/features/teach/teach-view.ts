/**
 * The view of `/teach` that an address names by its fragment. Any other fragment is the link of a
 * lesson, which opens with its hand-ins.
 */
export type TeachView = { name: "home" | "hand-ins" | "report" } | { name: "lesson"; link: string };

export const HAND_INS_HASH = "#hand-ins";
export const REPORT_HASH = "#report";

export function teachViewOf(hash: string): TeachView {
  if (hash === "" || hash === "#") return { name: "home" };
  if (hash === REPORT_HASH) return { name: "report" };
  return hash === HAND_INS_HASH ? { name: "hand-ins" } : { name: "lesson", link: hash.slice(1) };
}
