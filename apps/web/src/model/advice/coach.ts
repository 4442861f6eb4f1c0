/** The coach with the texts and the filter of its advice. The page loads it when idle. */
export { adviseProgram, applyFix } from "@corridor/coach";
export { concernsReader } from "./advice-in-challenge.ts";
export { adviceText } from "./advice-text.ts";
