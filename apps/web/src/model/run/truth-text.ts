import type { EvaluatedCondition } from "@corridor/program";
import { roundedSides } from "../../text/compared.ts";

/**
 * A comparison as a line displays it: short numbers that never contradict the truth.
 * @returns the sides in cm, the right one with its sign: "250.5" and "> 60"
 */
export function truthText(truth: EvaluatedCondition): { left: string; right: string } {
  const { left, right } = roundedSides(truth, 1);
  return { left: String(left), right: `${truth.is} ${right}` };
}
