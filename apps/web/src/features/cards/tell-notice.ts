/** Says that the program's robot gets nowhere, and leads to the line that it is about. */
import type { LoopNotice } from "@corridor/coach";
import type { i18n } from "i18next";
import { dismiss, tell, type ScreenStore } from "../../stores/screen-store.ts";
import type { WorkspaceStore } from "../../stores/workspace-store.ts";
import { focusLine } from "../program/focus-line.ts";

interface Ports {
  screen: ScreenStore;
  workspace: WorkspaceStore;
  words: Pick<i18n, "t">;
}

export function tellNotice(
  { screen, workspace, words }: Ports,
  { kind, line, times }: LoopNotice,
): void {
  if (line === "default") {
    tell(screen, {
      tone: "info",
      stays: true,
      text: words.t(`cards.loop.${kind}Otherwise`, { times }),
    });
    return;
  }
  const id = workspace.getState().lineIds[line];
  const message = tell(screen, {
    tone: "info",
    stays: true,
    text: words.t(`cards.loop.${kind}Line`, { times, line: line + 1 }),
    action: {
      label: words.t("cards.loop.show", { line: line + 1 }),
      run: () => {
        dismiss(screen, message);
        if (id !== undefined) focusLine(id);
      },
    },
  });
}
