import { showMessage } from "../screen/screen-store.ts";
import type { LessonsPorts } from "./lessons-ports.ts";

/** Shows a message if the device did not store a change of the lessons. */
export function reportUnlessStored(
  { screen, words }: Pick<LessonsPorts, "screen" | "words">,
  isStored: boolean,
): void {
  if (!isStored) showMessage(screen, { tone: "bad", text: words.t("missions:card.blocked") });
}
