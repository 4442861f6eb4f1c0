/** Saves the run so far, which the simulator writes when it is asked. */
import type { i18n } from "i18next";
import type { Services } from "../../app/services.ts";
import { tell } from "../../stores/screen-store.ts";
import { saveDocument } from "./save-file.ts";

export function saveRun(
  { simulator, screen }: Pick<Services, "simulator" | "screen">,
  words: Pick<i18n, "t">,
): void {
  const end = simulator.listen((message) => {
    if (message.type !== "run-saved") return;
    end();
    if (message.saved.ok) saveDocument(message.saved.run, "run");
    else tell(screen, { tone: "bad", text: words.t("timeline.share.tooMuch") });
  });
  simulator.send({ type: "save-run" });
}
