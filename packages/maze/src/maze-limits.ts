/**
 * Characters and bounds of the maze document. They are separate from the schema so that the
 * simulation worker, which only reads cells, does not load the schema library.
 */

export const MAX_SIDE = 256;
export const MAX_GOALS = 256;
export const MAX_NAME_LENGTH = 100;
export const BLOCK = "#";
export const OPEN = ".";

export const headingNames = ["north", "east", "south", "west"] as const;
export type HeadingName = (typeof headingNames)[number];
