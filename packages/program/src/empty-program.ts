/** Creates a program without lines, which always runs the default action. */
import type { ProgramDocument } from "./program-document.ts";
import { DEFAULT_ACTION } from "./vocabulary.ts";

export function emptyProgram(name = ""): ProgramDocument {
  return { format: "corridor/program", version: 1, name, default: DEFAULT_ACTION, rules: [] };
}
