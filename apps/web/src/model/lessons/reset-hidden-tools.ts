/** Undoes the choices that a task hides, because the student could not change them there. */
import type { Rights } from "@corridor/challenge";
import type { LessonsPorts } from "./lessons-ports.ts";

export function resetHiddenTools(
  { screen, run, simulator }: Pick<LessonsPorts, "screen" | "run" | "simulator">,
  { tools }: Pick<Rights, "tools">,
): void {
  if (!tools.has("measure") && screen.getState().tool === "measure") {
    screen.setState({ tool: "blocks" });
  }
  if (!tools.has("speed") && run.getState().speed !== 1) {
    run.setState({ speed: 1 });
    simulator.send({ type: "speed", speed: 1 });
  }
}
