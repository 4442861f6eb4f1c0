/** The pages for teachers: they load their own files, and start no simulator. */
import "../ui/base.css";
import "../ui/fonts/inter.css";
import { I18nextProvider } from "react-i18next";
import { startServiceWorker } from "../features/offline/service-worker.ts";
import { TeachPage } from "../features/teach/TeachPage.tsx";
import { LanguageProvider } from "../model/language-context.ts";
import type { PageParts } from "../model/page-parts.ts";

export async function openPage({ root, words, language, device, tools }: PageParts): Promise<void> {
  await words.loadNamespaces(["teach", "report"]);
  root.render(
    <I18nextProvider i18n={words}>
      <LanguageProvider value={language}>
        <TeachPage device={device} tools={tools} />
      </LanguageProvider>
    </I18nextProvider>,
  );
  if (!import.meta.env.PROD) return;
  try {
    // A newer version is offered on the student's page, and opens with the next visit.
    await startServiceWorker({ onReady: () => undefined, onTaken: () => undefined });
  } catch {
    // Private windows and full storages refuse a service worker: the page needs a network.
  }
}
