/** The six programs of the 2013 thesis, Figures 19 and 22 to 26. */
import { readFileSync } from "node:fs";
import { readProgram, type ProgramDocument } from "../program-document.ts";

/** Outcome of a program according to the thesis. */
export type PaperOutcome = "back and forth" | "correct" | "incorrect";

export interface PaperProgram {
  figure: number;
  outcome: PaperOutcome;
  program: ProgramDocument;
}

function read(figure: number, file: string, outcome: PaperOutcome): PaperProgram {
  const result = readProgram(readFileSync(new URL(`paper/${file}`, import.meta.url), "utf8"));
  if (!result.ok) throw new Error(`${file} is not a valid program`);
  return { figure, outcome, program: result.value };
}

/** In figure order. */
export const paperPrograms: readonly PaperProgram[] = [
  read(19, "figure-19-back-and-forth.json", "back and forth"),
  read(22, "figure-22-right-wall.json", "correct"),
  read(23, "figure-23-farthest-distance.json", "correct"),
  read(24, "figure-24-incorrect.json", "incorrect"),
  read(25, "figure-25-incorrect.json", "incorrect"),
  read(26, "figure-26-incorrect.json", "incorrect"),
];
