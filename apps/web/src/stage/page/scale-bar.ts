/** The scale bar: a round number of centimetres with a readable width. Pure. */
import { CELL } from "@corridor/maze";

/** Minimum width for the labels "0", the middle and the end beside each other. */
const LEAST_PX = 70;
const lengths = [50, 100, 200, 500];
const TICKS = 10;

/** `units`: its length; `width`: the same in px; `ticks`: positions of its eleven marks, in px. */
export function scaleBar(cellPx: number): { units: number; width: number; ticks: number[] } {
  const pixelsOf = (units: number): number => (units * cellPx) / CELL;
  const units = lengths.find((length) => pixelsOf(length) >= LEAST_PX) ?? 500;
  const width = pixelsOf(units);
  return {
    units,
    width,
    ticks: Array.from({ length: TICKS + 1 }, (_, at) => (at * width) / TICKS),
  };
}
