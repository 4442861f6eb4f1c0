/** The example of a first visit. */
import type { ProgramDocument } from "@corridor/program";
import { firstProgram } from "../../simulator/protocol/first-project.ts";

const example = JSON.stringify(firstProgram.rules);

/**
 * Whether the program is the unchanged example of a first visit. A student's own program starts
 * without a name.
 */
export function isExample({ name, default: otherwise, rules }: ProgramDocument): boolean {
  return name !== "" && otherwise === firstProgram.default && JSON.stringify(rules) === example;
}
