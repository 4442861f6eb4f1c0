/**
 * Says that the program's robot gets nowhere, and leads to the line that it is about. It is true of one
 * run of one program in one maze: with another it goes.
 */
import type { LoopNotice } from "@corridor/coach";
import type { i18n } from "i18next";
import type { RunStore } from "../../stores/run-store.ts";
import { dismiss, tell, type ScreenStore } from "../../stores/screen-store.ts";
import type { WorkspaceStore } from "../../stores/workspace-store.ts";
import { focusLine } from "../program/focus-line.ts";

interface Ports {
  screen: ScreenStore;
  workspace: WorkspaceStore;
  run: RunStore;
  words: Pick<i18n, "t">;
}

export function tellNotice(
  { screen, workspace, run, words }: Ports,
  { kind, line, times }: LoopNotice,
): void {
  const id = line === "default" ? undefined : workspace.getState().lineIds[line];
  const message = tell(screen, {
    tone: "info",
    stays: true,
    text:
      line === "default"
        ? words.t(`cards.loop.${kind}Otherwise`, { times })
        : words.t(`cards.loop.${kind}Line`, { times, line: line + 1 }),
    action:
      line === "default" || id === undefined
        ? undefined
        : {
            label: words.t("cards.loop.show", { line: line + 1 }),
            run: () => {
              end();
              focusLine(id);
            },
          },
  });
  const ends = [
    workspace.subscribe(() => end()),
    run.subscribe(({ nowTick }, before) => {
      if (nowTick < before.nowTick) end();
    }),
  ];
  function end(): void {
    dismiss(screen, message);
    for (const each of ends) each();
  }
}
