/** Reports a side effect of an edit, with an Undo button while Undo reverts that edit. */
import type { i18n } from "i18next";
import { showMessage, type ScreenStore } from "../screen/screen-store.ts";
import { dismissOnce } from "./dismiss-once.ts";
import { undo, type WorkspaceStore } from "./workspace-store.ts";

/** Reports on the newest edit. The next edit dismisses the message. */
export function showUndoable(
  { screen, workspace }: { screen: ScreenStore; workspace: WorkspaceStore },
  words: Pick<i18n, "t">,
  text: string,
): void {
  const id = showMessage(screen, {
    tone: "info",
    text,
    action: { label: words.t("stage.undo"), run: () => undo(workspace) },
  });
  const { maze, program } = workspace.getState();
  dismissOnce({ screen, workspace }, id, (now) => now.maze !== maze || now.program !== program);
}
