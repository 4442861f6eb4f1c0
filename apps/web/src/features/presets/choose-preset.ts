/** Puts a maze in place of the one that is open, with a message that takes it back. */
import type { MazeDocument } from "@corridor/maze";
import type { i18n } from "i18next";
import type { Services } from "../../app/services.ts";
import { dismiss, tell } from "../../stores/screen-store.ts";
import { setMaze, undo } from "../../stores/workspace-store.ts";

/** The robot goes to the start of the maze. The program stays. */
export function chooseMaze(
  { workspace, simulator, screen }: Pick<Services, "workspace" | "simulator" | "screen">,
  words: Pick<i18n, "t">,
  maze: MazeDocument,
): void {
  const before = workspace.getState().maze;
  setMaze(workspace, maze);
  simulator.send({ type: "reset" });
  const after = workspace.getState().maze;
  const message = tell(screen, {
    tone: "info",
    text: words.t("presets.chosen", { name: maze.name }),
    action: {
      label: words.t("presets.undo"),
      run: () => {
        dismiss(screen, message);
        // Later edits have steps of their own in the history, which stay: the old maze comes on top.
        if (workspace.getState().maze === after) undo(workspace);
        else setMaze(workspace, before);
        simulator.send({ type: "reset" });
      },
    },
  });
}
