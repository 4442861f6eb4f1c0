/** The coach as the page fetches it once it has time, with the words of its advice and for whom it is. */
export { adviseProgram, applyFix } from "@corridor/coach";
export { concernsReader } from "./advice-in-challenge.ts";
export { adviceText } from "./advice-text.ts";
