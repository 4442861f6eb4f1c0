/** From the example to a program of one's own; it comes when "Write my own" is pressed. */
import { emptyProgram } from "@corridor/program";
import type { i18n } from "i18next";
import type { Services } from "../../app/services.ts";
import { tellUndoable } from "../stage/tell-undoable.ts";
import { loadProgram } from "./program-actions.ts";

/** An empty program, the robot at its start, the goal in a message, and the focus where a line is added. */
export function writeOwn(
  services: Pick<Services, "workspace" | "simulator" | "screen">,
  words: Pick<i18n, "t">,
): void {
  loadProgram(services.workspace, emptyProgram());
  services.simulator.send({ type: "reset" });
  tellUndoable(services, words, words.t("program.begun"));
}
