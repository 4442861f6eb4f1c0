/** Bounds of a run document. A longer document is rejected, not truncated. */
import { TICKS_PER_SECOND } from "@corridor/protocol";

/** 24 hours of simulated time. */
export const MAX_RUN_TICKS = 24 * 60 * 60 * TICKS_PER_SECOND;
export const MAX_RUN_INPUTS = 100_000;
export const MAX_RUN_NAME_LENGTH = 100;
/** In UTF-16 code units, including whitespace. */
export const MAX_RUN_TEXT_LENGTH = 8 * 1024 * 1024;
