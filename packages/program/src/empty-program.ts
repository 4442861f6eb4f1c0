/** A program without lines: the robot only does what "otherwise" says. */
import type { ProgramDocument } from "./program-document.ts";
import { DEFAULT_ACTION } from "./vocabulary.ts";

export function emptyProgram(name = ""): ProgramDocument {
  return { format: "corridor/program", version: 1, name, default: DEFAULT_ACTION, rules: [] };
}
