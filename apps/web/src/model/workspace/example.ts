/** The example of a first visit. */
import { isSameBehaviour, type ProgramDocument } from "@corridor/program";
import { firstProgram } from "../../simulator/protocol/first-project.ts";

/**
 * Whether the program is the unchanged example of a first visit. A student's own program starts
 * without a name.
 */
export function isExample(program: ProgramDocument): boolean {
  return program.name !== "" && isSameBehaviour(program, firstProgram);
}
