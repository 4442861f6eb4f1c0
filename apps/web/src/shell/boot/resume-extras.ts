/** Resumes the class, sounds and the ghosts of a race. Loaded only if the tab has any. */
import type { i18n } from "i18next";
import { showMessage } from "../../model/screen/screen-store.ts";
import { RACE_KEY } from "../../model/run/race-store.ts";
import type { Services } from "../../model/services.ts";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";

/** The class that this tab has joined. Without its file, the page works as outside of a class. */
export async function resumeClass(
  services: Services,
  words: i18n,
  tab: KeyValueStorage,
): Promise<void> {
  try {
    const { openClass } = await import("../../features/class/open-class.tsx");
    await openClass(services, words, tab);
  } catch {
    showMessage(services.screen, { tone: "bad", text: words.t("offline.partFailed") });
  }
}

export async function resumeExtras(
  services: Services,
  words: i18n,
  tab: KeyValueStorage,
): Promise<void> {
  const { soundsOf } = await import("../../features/sound/sounds.ts");
  soundsOf(services.run).resume();
  if (tab.getItem(RACE_KEY) === null) return;
  const [{ raceService }] = await Promise.all([
    import("../../features/race/race-service.ts"),
    words.loadNamespaces("race"),
  ]);
  await raceService(services, words).resume();
}
