/**
 * Describes the robot: its position, its readings and the running line, as one message for eyes and
 * screen readers. A new description replaces the last one, so that two ticks never appear side by
 * side.
 */
import type { i18n } from "i18next";
import { showsHelp, type ChallengeStore } from "../challenge/challenge-store.ts";
import type { RunStore } from "../run/run-store.ts";
import type { WorkspaceStore } from "../workspace/workspace-store.ts";
import { dismiss, showMessage, type ScreenStore } from "../screen/screen-store.ts";

export interface DescribePorts {
  run: RunStore;
  workspace: WorkspaceStore;
  screen: ScreenStore;
  challenge: ChallengeStore;
}

const shown = new WeakMap<ScreenStore, number>();

/** Describes the robot at the displayed tick. Shows a message if a file fails to load. */
export async function describeRobot(
  { run, workspace, screen, challenge }: DescribePorts,
  words: i18n,
): Promise<void> {
  let text: string;
  try {
    const [{ describeText }] = await Promise.all([
      import("./run-words.ts"),
      words.loadNamespaces("runDetails"),
    ]);
    if (run.getState().snapshot === null) return;
    text = describeText(
      { t: words.t, language: words.language },
      workspace.getState().program,
      run.getState(),
      showsHelp(challenge.getState().rights, "truth"),
    );
  } catch {
    showMessage(screen, { tone: "bad", text: words.t("offline.partFailed") });
    return;
  }
  const last = shown.get(screen);
  if (last !== undefined) dismiss(screen, last);
  // While the robot rests, the message stays until the tick changes.
  const isStill = run.getState().snapshot?.state !== "running";
  const message = showMessage(screen, { tone: "info", stays: isStill, text });
  shown.set(screen, message);
  if (!isStill) return;
  const described = run.getState().snapshot?.tick;
  const end = run.subscribe(({ snapshot }) => {
    if (snapshot?.tick === described) return;
    end();
    dismiss(screen, message);
  });
}
