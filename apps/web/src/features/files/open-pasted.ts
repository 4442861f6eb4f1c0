/** Opens what the user pastes into the page. Loaded with the first paste. */
import type { i18n } from "i18next";
import { isPaused } from "../../model/classes/class-store.ts";
import { showMessage } from "../../model/screen/screen-store.ts";
import type { Services } from "../../model/services.ts";
import type { TextFile } from "../../ui/incoming-files.ts";
import { readPasted } from "./read-pasted.ts";

/** @param take opens a text that is meant as a file */
export async function openPasted(
  { screen, classes }: Pick<Services, "screen" | "classes">,
  { t }: Pick<i18n, "t">,
  text: string,
  take: (files: readonly TextFile[]) => Promise<void>,
): Promise<void> {
  if (isPaused(classes)) return;
  const pasted = readPasted(text, location.origin);
  if (pasted === "file") {
    const name = t("files.pasted");
    await take([{ name, size: text.length, text: () => Promise.resolve(text) }]);
  } else if (pasted === "script" || pasted === "other") {
    const key = pasted === "script" ? "files.scriptAddress" : "files.strayText";
    showMessage(screen, { tone: "info", text: t(key) });
  } else {
    // Navigates as the address bar does: for this page, only the fragment changes.
    location.assign(pasted);
  }
}
