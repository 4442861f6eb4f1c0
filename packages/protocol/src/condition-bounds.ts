/** Bounds of conditions. In their own file so that the page's menus import no schemas. */

/** Largest number that a sensor is compared with, in units. */
export const MAX_THAN = 100_000;
/** Largest number that is added to the right reading, in units. */
export const MAX_PLUS = 100_000;
/** Largest number of conditions of a guarded motion. A program has as many rules. */
export const MAX_CONDITIONS = 200;
