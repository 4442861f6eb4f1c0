/** A new empty maze, opened as a work of its own beside what was open. */
import { mazePresets } from "@corridor/maze";
import type { i18n } from "i18next";
import type { Services } from "../../app/services.ts";
import { dismiss, tell } from "../../stores/screen-store.ts";

/** The reader's program comes along; a message leads back. */
export function openEmptyMaze(
  { works, screen }: Pick<Services, "works" | "screen">,
  words: Pick<i18n, "t">,
): void {
  const empty = mazePresets.find(({ id }) => id === "empty");
  if (empty === undefined) return;
  const back = works.begin({ ...empty.maze, name: words.t("works.newMazeName") }, null);
  const id = tell(screen, {
    tone: "info",
    text: words.t("works.begun"),
    action: {
      label: words.t("works.back"),
      run: () => {
        dismiss(screen, id);
        back();
      },
    },
  });
}
