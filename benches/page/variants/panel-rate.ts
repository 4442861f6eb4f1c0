/** Interval between two updates of the panel, in milliseconds. */
export const PANEL_MS = 50;
