/** Restarts a run after a bump and a fix. Run alone would resume at the wall. */
import type { i18n } from "i18next";
import type { RunStore } from "../../model/run/run-store.ts";
import { dismiss, showMessage, type ScreenStore } from "../../model/screen/screen-store.ts";
import { dismissOnce } from "../../model/workspace/dismiss-once.ts";
import type { WorkspaceStore } from "../../model/workspace/workspace-store.ts";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";

type Simulator = Pick<SimulatorClient, "send">;

/** Resets the robot to the start and runs the current program. */
export function runFromStart(simulator: Simulator): void {
  simulator.send({ type: "reset" });
  simulator.send({ type: "run" });
}

interface FixedParts {
  screen: ScreenStore;
  run: RunStore;
  workspace: WorkspaceStore;
  simulator: Simulator;
  words: Pick<i18n, "t">;
}

/**
 * Reports the fix, and offers a run from the start. The message disappears when the robot leaves the
 * place of the bump, or when the program changes: a fix that Undo reverted is not "fixed".
 */
export function showFixed({ screen, run, workspace, simulator, words }: FixedParts): void {
  const id = showMessage(screen, {
    tone: "info",
    text: words.t("cards.fix.done"),
    stays: true,
    action: { label: words.t("cards.fromStart"), run: () => runFromStart(simulator) },
  });
  const { nowTick: at, event: bump } = run.getState();
  const end = run.subscribe(({ snapshot, nowTick, event }) => {
    // At the highest speed, no update may fall between a new start and the next bump.
    const isSame = nowTick === at && (event === bump || bump === null);
    if (isSame && nowTick > 0 && snapshot?.state !== "running") return;
    end();
    dismiss(screen, id);
  });
  const { program: fixed } = workspace.getState();
  dismissOnce({ screen, workspace }, id, ({ program }) => program !== fixed);
}
