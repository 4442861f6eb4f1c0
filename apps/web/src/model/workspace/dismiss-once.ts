/** Dismisses a message about an edit as soon as its text is no longer true. */
import { dismiss, type ScreenStore } from "../screen/screen-store.ts";
import type { Workspace, WorkspaceStore } from "./workspace-store.ts";

/** @param isOver whether the maze and the program contradict the message; checked at each change */
export function dismissOnce(
  { screen, workspace }: { screen: ScreenStore; workspace: WorkspaceStore },
  message: number,
  isOver: (now: Workspace) => boolean,
): void {
  const stop = workspace.subscribe((now) => {
    const isShown = screen.getState().messages.some(({ id }) => id === message);
    if (isShown && !isOver(now)) return;
    stop();
    dismiss(screen, message);
  });
}
