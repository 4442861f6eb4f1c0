/** Saves the run so far, which the simulator writes on request. */
import type { RunDocument } from "@corridor/recording";
import type { i18n } from "i18next";
import type { Services } from "../../model/services.ts";
import { showMessage } from "../../model/screen/screen-store.ts";
import { saveRun as askForRun } from "../../model/run/run-requests.ts";
import { saveDocument } from "../../ui/save-file.ts";

export function saveRun(
  { simulator, screen }: Pick<Services, "simulator" | "screen">,
  words: Pick<i18n, "t">,
): void {
  askForRun(simulator, (saved) => {
    if (saved.ok) saveDocument(JSON.parse(saved.text) as RunDocument, "run");
    else showMessage(screen, { tone: "bad", text: words.t("timeline.share.tooMuch") });
  });
}
