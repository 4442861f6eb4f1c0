/** The way on from a bump whose program was mended: Run alone would go on from the wall. */
import type { i18n } from "i18next";
import type { RunStore } from "../../stores/run-store.ts";
import { dismiss, showMessage, type ScreenStore } from "../../stores/screen-store.ts";
import type { SimulatorClient } from "../../worker/simulator-client.ts";

type Simulator = Pick<SimulatorClient, "send">;

/** Puts the robot to its start and lets it go, with the program as it is now. */
export function runFromStart(simulator: Simulator): void {
  simulator.send({ type: "reset" });
  simulator.send({ type: "run" });
}

interface MendedParts {
  screen: ScreenStore;
  run: RunStore;
  simulator: Simulator;
  words: Pick<i18n, "t">;
}

/** Says that it is mended, and offers the new run for as long as the robot stands where it bumped. */
export function tellMended({ screen, run, simulator, words }: MendedParts): void {
  const id = showMessage(screen, {
    tone: "info",
    text: words.t("cards.mend.done"),
    stays: true,
    action: { label: words.t("cards.fromStart"), run: () => runFromStart(simulator) },
  });
  const end = run.subscribe(({ snapshot, nowTick }) => {
    if (nowTick > 0 && snapshot?.state !== "running") return;
    end();
    dismiss(screen, id);
  });
}
