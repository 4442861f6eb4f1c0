/** Reads the run that a tab kept over a reload. A file of its own, because it needs the schemas. */
import { readRun, type RunDocument } from "@corridor/recording";

/** @returns null for a text that is no run: another version of the page may have written it */
export function readKeptRun(text: string): RunDocument | null {
  const read = readRun(text);
  return read.ok ? read.value : null;
}
