/** The scale bar: a round number of centimetres that is neither a speck nor longer than a thumb. Pure. */
import { CELL } from "../../canvas/viewport.ts";

/** Room that "0", the middle and the last number need beside each other. */
const LEAST_PX = 70;
const lengths = [50, 100, 200, 500];
const TICKS = 10;

/** `units` long and `width` pixels wide; `ticks`: pixels of its eleven marks. */
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
