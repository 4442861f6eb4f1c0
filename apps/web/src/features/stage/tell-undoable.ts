/** Says what an edit took along that nobody asked for, with Undo while Undo still means that edit. */
import type { i18n } from "i18next";
import { dismiss, showMessage, type ScreenStore } from "../../stores/screen-store.ts";
import { undo, type WorkspaceStore } from "../../stores/workspace-store.ts";

/** Tells about the edit just made; the message leaves with the next edit, whoever makes it. */
export function tellUndoable(
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
  const stop = workspace.subscribe((now) => {
    if (now.maze === maze && now.program === program) return;
    stop();
    dismiss(screen, id);
  });
}
