/**
 * What this tab had before a reload besides its documents: its class, sounds, and the ghosts of a
 * race. Loaded only if there were any.
 */
import type { i18n } from "i18next";
import { CLASS_KEY } from "../../model/classes/class-key.ts";
import { RACE_KEY } from "../../model/run/race-store.ts";
import { showMessage } from "../../model/screen/screen-store.ts";
import type { Services } from "../../model/services.ts";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";

/**
 * Opens the class, whose pause must be known before the run is restored.
 * @returns a function that resumes the rest once the run is restored
 */
export async function openExtras(
  services: Services,
  words: i18n,
  tab: KeyValueStorage,
): Promise<() => Promise<void>> {
  const openLesson = tab.getItem(CLASS_KEY) === null ? null : await openClass(services, words, tab);
  return async () => {
    openLesson?.();
    const parts = [resumeSounds(services), resumeRace(services, words, tab)];
    const resumed = await Promise.allSettled(parts);
    if (resumed.some(({ status }) => status === "rejected")) reportMissing(services, words);
  };
}

/** Without its file, the page works as outside of a class. */
async function openClass(
  services: Services,
  words: i18n,
  tab: KeyValueStorage,
): Promise<(() => void) | null> {
  try {
    const part = await import("../../features/class/open-class.tsx");
    return await part.openClass(services, words, tab);
  } catch {
    reportMissing(services, words);
    return null;
  }
}

async function resumeSounds({ run }: Services): Promise<void> {
  const { soundsOf } = await import("../../features/sound/sounds.ts");
  soundsOf(run).resume();
}

async function resumeRace(services: Services, words: i18n, tab: KeyValueStorage): Promise<void> {
  if (tab.getItem(RACE_KEY) === null) return;
  const [{ raceService }] = await Promise.all([
    import("../../features/race/race-service.ts"),
    words.loadNamespaces("race"),
  ]);
  await raceService(services, words).resume();
}

/** A file did not come. */
function reportMissing({ screen }: Services, words: i18n): void {
  showMessage(screen, { tone: "bad", text: words.t("offline.partFailed") });
}
