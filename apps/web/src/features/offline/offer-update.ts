/**
 * Offers a new version of the page. The page never reloads by itself, because a run may be in
 * progress.
 */
import type { i18n } from "i18next";
import type { Services } from "../../model/services.ts";
import { dismiss, showMessage } from "../../model/screen/screen-store.ts";
import { startServiceWorker } from "./service-worker.ts";

/**
 * Starts the service worker and shows a message for each new version.
 * @param reload reloads the page
 */
export async function offerUpdates(
  { screen, projects }: Pick<Services, "screen" | "projects">,
  words: Pick<i18n, "t">,
  reload: () => void,
): Promise<void> {
  let shown: number | null = null;
  const offer = (take: () => Promise<void>): void => {
    // The newest offer replaces the one before it.
    if (shown !== null) dismiss(screen, shown);
    const id = showMessage(screen, {
      tone: "info",
      stays: true,
      text: words.t("offline.newVersion"),
      action: {
        label: words.t("offline.reload"),
        run: () => {
          projects.autosave.flush();
          if (screen.getState().saved === "blocked") {
            // A reload would lose what the device does not store: the user saves it elsewhere
            // first.
            showMessage(screen, { tone: "bad", text: words.t("projects.blocked") });
            return;
          }
          dismiss(screen, id);
          void take().then(reload);
        },
      },
    });
    shown = id;
  };
  await startServiceWorker({ onReady: offer, onTaken: () => offer(() => Promise.resolve()) });
}
