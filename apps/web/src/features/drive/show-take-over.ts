/**
 * Shows once that Me drives from now on, or that the challenge does not allow it. This module is a
 * separate chunk.
 */
import type { i18n } from "i18next";
import type { DriverName } from "@corridor/protocol";
import { dismiss, showMessage, type ScreenStore } from "../../model/screen/screen-store.ts";

const events = ["refused", "fromScript", "fromProgram"] as const;

/** @param from the driver until now; null if the open challenge does not allow Me */
export async function showTakeOver(
  screen: ScreenStore,
  words: Pick<i18n, "t" | "loadNamespaces">,
  from: DriverName | null,
): Promise<void> {
  await words.loadNamespaces("runDetails");
  const event = from === null ? "refused" : from === "remote" ? "fromScript" : "fromProgram";
  // The message of an earlier take-over is no longer true.
  const texts = events.map((each) => words.t(`runDetails:hand.${each}`));
  for (const { id, text } of screen.getState().messages) {
    if (texts.includes(text)) dismiss(screen, id);
  }
  showMessage(screen, { tone: "info", text: words.t(`runDetails:hand.${event}`) });
}
