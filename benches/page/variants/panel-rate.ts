/** How often a panel is written, in milliseconds. */
export const PANEL_MS = 50;
