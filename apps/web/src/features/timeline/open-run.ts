/**
 * Opens a recorded run, of a link or a file: its maze and program become a work beside the reader's own,
 * and the run is shown from its start, to be watched, gone back in and run on from.
 */
import type { FieldProblem } from "@corridor/protocol";
import type { RunDocument } from "@corridor/recording";
import type { i18n } from "i18next";
import type { Services } from "../../app/services.ts";
import { dismiss, tell } from "../../stores/screen-store.ts";
import type { LoadedRun } from "../../worker/worker-messages.ts";

type Opener = Pick<Services, "simulator" | "works" | "screen">;

/**
 * @param run one that passed its schema
 * @returns nothing when it was opened; else what is wrong with it, and nothing has changed
 */
export async function openRun(
  { simulator, works, screen }: Opener,
  words: Pick<i18n, "t">,
  run: RunDocument,
): Promise<readonly FieldProblem[]> {
  const loaded = await load(simulator, run);
  if (!loaded.ok) return loaded.problems;
  const back = works.beginShared(loaded.maze, loaded.program);
  simulator.send({ type: "seek", tick: 0 });
  const id = tell(screen, {
    tone: "info",
    text: words.t("timeline.recorded"),
    action: {
      label: words.t("share.back"),
      run: () => {
        dismiss(screen, id);
        back();
        simulator.send({ type: "reset" });
      },
    },
  });
  return [];
}

/** The worker repeats the run and says how it ended. */
function load(simulator: Opener["simulator"], run: RunDocument): Promise<LoadedRun> {
  return new Promise((resolve) => {
    const end = simulator.listen((message) => {
      if (message.type !== "run-loaded") return;
      end();
      resolve(message.loaded);
    });
    simulator.send({ type: "load-run", run });
  });
}
