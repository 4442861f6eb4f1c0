/**
 * Describe: where the robot is, what it sees and which line runs, as one message that is read and heard.
 * A newer one takes its place, so that never two moments stand side by side.
 */
import type { i18n } from "i18next";
import type { Services } from "../../app/services.ts";
import { dismiss, showMessage, type ScreenStore } from "../../stores/screen-store.ts";

const shown = new WeakMap<ScreenStore, number>();

/** Describes the shown moment; a file that does not come is told like any other. */
export async function describeRobot(
  { run, workspace, screen }: Pick<Services, "run" | "workspace" | "screen">,
  words: i18n,
): Promise<void> {
  let text: string;
  try {
    const [{ describeText }] = await Promise.all([
      import("./run-words.ts"),
      words.loadNamespaces("runDetails"),
    ]);
    const { snapshot } = run.getState();
    if (snapshot === null) return;
    text = describeText(
      { t: words.t, language: words.language },
      workspace.getState().program,
      snapshot,
    );
  } catch {
    showMessage(screen, { tone: "bad", text: words.t("offline.partFailed") });
    return;
  }
  const last = shown.get(screen);
  if (last !== undefined) dismiss(screen, last);
  // It stays as long as it is true.
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
