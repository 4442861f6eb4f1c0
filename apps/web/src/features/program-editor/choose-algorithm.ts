import type { ProgramDocument } from "@corridor/program";
import type { i18n } from "i18next";
import type { Services } from "../../model/services.ts";
import { showUndoable } from "../../model/workspace/show-undoable.ts";
import { loadProgram } from "../../model/workspace/program-actions.ts";

/**
 * Replaces the program with a preset algorithm, and shows a message that offers undo. The maze and
 * the robot in it stay.
 */
export function chooseAlgorithm(
  services: Pick<Services, "workspace" | "screen">,
  words: Pick<i18n, "t">,
  program: ProgramDocument,
): void {
  loadProgram(services.workspace, program);
  showUndoable(services, words, words.t("program.loaded", { name: program.name }));
}
