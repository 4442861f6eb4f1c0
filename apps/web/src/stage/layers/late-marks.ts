/** The drawing function of marks, once it is loaded: most visits have none. */
import type { drawMarks } from "./marks.ts";

export const lateMarks: { draw: typeof drawMarks | null } = { draw: null };
