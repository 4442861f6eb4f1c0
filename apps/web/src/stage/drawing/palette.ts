/**
 * Colours of the canvas, read from the custom properties of the page. Reading them costs a style
 * calculation, so they are read once per theme, never once per frame.
 */

const names = {
  paper: "--paper",
  surface: "--surface",
  ink: "--ink",
  ink2: "--ink-2",
  ink3: "--ink-3",
  onInk: "--on-ink",
  edge: "--edge",
  floor: "--floor",
  floorLine: "--floor-line",
  wall: "--wall",
  wallSeam: "--wall-seam",
  wallEdge: "--wall-edge",
  live: "--live",
  onLive: "--on-live",
  liveInk: "--live-ink",
  liveSoft: "--live-soft",
  beam: "--beam",
  robotEdge: "--robot-edge",
  robotVisor: "--robot-visor",
  robotWheel: "--robot-wheel",
  robotEye: "--robot-eye",
  good: "--good",
  goodInk: "--good-ink",
  goodBg: "--good-bg",
  bad: "--bad",
  badBg: "--bad-bg",
  font: "--font-ui",
} as const;

/** CSS colours by role, and the page's font family. */
export type Palette = Record<keyof typeof names, string>;

/**
 * Reads the current colours.
 * @param valueOf returns the value of a custom property, empty if it is unknown
 */
export function readPalette(valueOf: (property: string) => string): Palette {
  const entries = Object.entries(names).map(([role, property]) => [role, valueOf(property).trim()]);
  return Object.fromEntries(entries) as Palette;
}
