/** Opens a new empty maze as its own project. */
import type { MazeDocument } from "@corridor/maze";
import type { i18n } from "i18next";
import type { Services } from "../../model/services.ts";
import { dismiss, showMessage } from "../../model/screen/screen-store.ts";
import { programForMaze } from "../../model/workspace/own-program.ts";

const COLUMNS = 11;
const ROWS = 7;

function emptyMaze(name: string): MazeDocument {
  return {
    format: "corridor/maze",
    version: 1,
    name,
    blocks: Array.from({ length: ROWS }, () => ".".repeat(COLUMNS)),
    start: { column: 0, row: ROWS - 1, heading: "east" },
    goals: [],
  };
}

/**
 * The new project takes over the user's own program. A message leads back to the earlier project.
 */
export function openEmptyMaze(
  { projects, screen, workspace }: Pick<Services, "projects" | "screen" | "workspace">,
  words: Pick<i18n, "t">,
): void {
  const program = programForMaze(workspace.getState().program, words);
  const back = projects.begin(emptyMaze(words.t("projects.newMazeName")), program);
  const id = showMessage(screen, {
    tone: "info",
    text: words.t("projects.created"),
    action: {
      label: words.t("projects.back"),
      run: () => {
        dismiss(screen, id);
        back();
      },
    },
  });
}
