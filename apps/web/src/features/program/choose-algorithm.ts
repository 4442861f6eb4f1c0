/** Puts a ready-made algorithm in place of the program, with a message that takes it back. */
import type { ProgramDocument } from "@corridor/program";
import type { i18n } from "i18next";
import type { Services } from "../../app/services.ts";
import { tellUndoable } from "../stage/tell-undoable.ts";
import { loadProgram } from "./program-actions.ts";

/** The maze stays, and so does the robot in it. */
export function chooseAlgorithm(
  services: Pick<Services, "workspace" | "screen">,
  words: Pick<i18n, "t">,
  program: ProgramDocument,
): void {
  loadProgram(services.workspace, program);
  tellUndoable(services, words, words.t("program.loaded", { name: program.name }));
}
