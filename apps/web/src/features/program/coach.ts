/** The coach as the page fetches it once it has time, with whom its advice is for. */
export { adviseProgram, applyMend } from "@corridor/coach";
export { concernsReader } from "./advice-in-challenge.ts";
