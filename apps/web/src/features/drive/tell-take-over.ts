/** Says once that the hand drives from now on, or that it may not. Comes in a file of its own. */
import type { i18n } from "i18next";
import type { DriverName } from "@corridor/protocol";
import { dismiss, showMessage, type ScreenStore } from "../../stores/screen-store.ts";

const events = ["refused", "fromScript", "fromProgram"] as const;

/** @param from who drove until now; null: the open challenge leaves nothing to the hand */
export async function tellTakeOver(
  screen: ScreenStore,
  words: Pick<i18n, "t" | "loadNamespaces">,
  from: DriverName | null,
): Promise<void> {
  await words.loadNamespaces("runDetails");
  const event = from === null ? "refused" : from === "remote" ? "fromScript" : "fromProgram";
  // What was said of an earlier take-over no longer holds.
  const texts = events.map((each) => words.t(`runDetails:hand.${each}`));
  for (const { id, text } of screen.getState().messages) {
    if (texts.includes(text)) dismiss(screen, id);
  }
  showMessage(screen, { tone: "info", text: words.t(`runDetails:hand.${event}`) });
}
