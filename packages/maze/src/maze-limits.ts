/**
 * The signs and bounds of the maze document, apart from its schema: who only looks cells up (the
 * simulation worker) need not load a schema library.
 */

export const MAX_SIDE = 256;
export const MAX_GOALS = 256;
export const MAX_NAME_LENGTH = 100;
export const BLOCK = "#";
export const OPEN = ".";

export const headingNames = ["north", "east", "south", "west"] as const;
export type HeadingName = (typeof headingNames)[number];
