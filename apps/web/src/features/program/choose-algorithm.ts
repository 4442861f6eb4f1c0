/** Puts a ready-made algorithm in place of the program, with a message that takes it back. */
import type { ProgramDocument } from "@corridor/program";
import type { i18n } from "i18next";
import type { Services } from "../../app/services.ts";
import { tell } from "../../stores/screen-store.ts";
import { undo } from "../../stores/workspace-store.ts";
import { loadProgram } from "./program-actions.ts";

/** The maze stays, and so does the robot in it. Undo works as long as nothing else was edited. */
export function chooseAlgorithm(
  { workspace, screen }: Pick<Services, "workspace" | "screen">,
  words: Pick<i18n, "t">,
  program: ProgramDocument,
): void {
  loadProgram(workspace, program);
  tell(screen, {
    tone: "info",
    text: words.t("program.loaded", { name: program.name }),
    action: {
      label: words.t("program.undo"),
      run: () => {
        if (workspace.getState().program === program) undo(workspace);
      },
    },
  });
}
