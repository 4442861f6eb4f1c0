/** Bounds of a run. In their own file so that the page imports no schemas. */
import { TICKS_PER_SECOND } from "./ticks.ts";

/** 24 hours of simulated time. */
export const MAX_RUN_TICKS = 24 * 60 * 60 * TICKS_PER_SECOND;
export const MAX_RUN_INPUTS = 100_000;
