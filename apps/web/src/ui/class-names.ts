/** One className from several, so that components read without string building. */

/** Joins the names that are there; false and undefined are left out. */
export function classNames(...names: readonly (string | false | undefined)[]): string {
  return names.filter(Boolean).join(" ");
}
