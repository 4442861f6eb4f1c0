/** Opens a new empty maze as its own project. */
import type { i18n } from "i18next";
import type { Services } from "../../model/services.ts";
import { dismiss, showMessage } from "../../model/screen/screen-store.ts";
import { emptyMaze } from "../../model/workspace/empty-maze.ts";
import { programForMaze } from "../../model/workspace/own-program.ts";

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
