/** In its own file so that the page imports no schemas. */

/**
 * Prefixes of the relay's keys by kind.
 *
 * - own, drive, watch: for a robot
 * - url: to drive or watch a robot, in a path only
 * - delete: deletes a short link's document
 * - connection: authenticates a long-poll connection
 * - teach, show, learn: for a class
 */
export const keyPrefixes = {
  own: "own_",
  drive: "drv_",
  watch: "wch_",
  url: "url_",
  delete: "del_",
  connection: "con_",
  teach: "tea_",
  show: "scr_",
  learn: "stu_",
} as const;
