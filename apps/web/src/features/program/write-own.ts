/** From the example to a program of one's own; it comes when "Write my own" is pressed. */
import { emptyProgram } from "@corridor/program";
import type { i18n } from "i18next";
import type { Services } from "../../app/services.ts";
import { dismiss, tell } from "../../stores/screen-store.ts";
import { undo } from "../../stores/workspace-store.ts";
import { loadProgram } from "./program-actions.ts";

/** An empty program, the robot at its start, the goal in a message, and the focus where a line is added. */
export function writeOwn(
  { workspace, simulator, screen }: Pick<Services, "workspace" | "simulator" | "screen">,
  words: Pick<i18n, "t">,
): void {
  loadProgram(workspace, emptyProgram());
  simulator.send({ type: "reset" });
  const { program } = workspace.getState();
  const id = tell(screen, {
    tone: "info",
    text: words.t("program.begun"),
    action: {
      label: words.t("program.undo"),
      run: () => {
        dismiss(screen, id);
        if (workspace.getState().program === program) undo(workspace);
      },
    },
  });
}
