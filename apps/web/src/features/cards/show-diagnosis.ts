/**
 * Reports that the program's robot makes no progress, with an action that focuses the line that
 * causes it. The message is valid for one run of one program in one maze. An edit, a reset or a
 * newer verdict dismisses it.
 */
import { causeLine, type Diagnosis } from "@corridor/coach";
import type { i18n } from "i18next";
import type { RunStore } from "../../model/run/run-store.ts";
import type { TimelineStore } from "../../model/run/timeline-store.ts";
import { dismiss, showMessage, type ScreenStore } from "../../model/screen/screen-store.ts";
import type { WorkspaceStore } from "../../model/workspace/workspace-store.ts";
import { focusLine } from "../../model/workspace/focus-line.ts";
import { diagnosisText, diagnosisWords } from "../../model/diagnosis/diagnosis-text.ts";

interface Ports {
  screen: ScreenStore;
  workspace: WorkspaceStore;
  run: RunStore;
  timeline: Pick<TimelineStore, "waitedUpTo">;
  words: Pick<i18n, "t" | "language" | "loadNamespaces">;
}

export async function showDiagnosis(
  { screen, workspace, run, timeline, words }: Ports,
  diagnosis: Diagnosis,
): Promise<void> {
  const { nowTick } = run.getState();
  await words.loadNamespaces("diagnosis");
  // The run may be over before the translations have loaded.
  if (run.getState().nowTick < nowTick) return;
  const known = diagnosisWords(words.t, words.language, (tick) => timeline.waitedUpTo(tick));
  const line = causeLine(diagnosis);
  const id = typeof line === "number" ? workspace.getState().lineIds[line] : undefined;
  const message = showMessage(screen, {
    tone: "info",
    stays: true,
    text: diagnosisText(known, diagnosis),
    action:
      typeof line !== "number" || id === undefined
        ? undefined
        : {
            label: known.t("diagnosis:show", { line: line + 1 }),
            run: () => {
              end();
              focusLine(id);
            },
          },
  });
  const ends = [
    workspace.subscribe(() => end()),
    run.subscribe((next, before) => {
      const isBump = next.event !== before.event && next.event?.kind === "bump";
      // The card of a bump is the newer verdict.
      if (next.nowTick < before.nowTick || (isBump && next.event?.diagnosis)) end();
    }),
  ];
  function end(): void {
    dismiss(screen, message);
    for (const each of ends) each();
  }
}
