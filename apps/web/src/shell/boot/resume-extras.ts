/** Resumes sounds and the ghosts of a race after a reload. Loaded only if there were any. */
import type { i18n } from "i18next";
import { RACE_KEY } from "../../model/run/race-store.ts";
import type { Services } from "../../model/services.ts";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";

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
