/** Bounds of a run document. A longer document is rejected, not truncated. */
export { MAX_RUN_INPUTS, MAX_RUN_TICKS } from "@corridor/protocol";
export const MAX_RUN_NAME_LENGTH = 100;
/** In UTF-16 code units, including whitespace. */
export const MAX_RUN_TEXT_LENGTH = 8 * 1024 * 1024;
