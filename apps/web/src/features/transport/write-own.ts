import { emptyProgram } from "@corridor/program";
import type { i18n } from "i18next";
import type { Services } from "../../model/services.ts";
import { showUndoable } from "../../model/workspace/show-undoable.ts";
import { loadProgram } from "../../model/workspace/program-actions.ts";

/**
 * Starts a program of the student's own: an empty program, the robot at its start, and a message
 * that offers undo. Loads when "Write my own" is pressed.
 */
export function writeOwn(
  services: Pick<Services, "workspace" | "simulator" | "screen">,
  words: Pick<i18n, "t">,
): void {
  loadProgram(services.workspace, emptyProgram());
  services.simulator.send({ type: "reset" });
  const hasGoal = services.workspace.getState().maze.goals.length > 0;
  showUndoable(services, words, words.t(hasGoal ? "program.emptied" : "program.emptiedNoGoal"));
}
