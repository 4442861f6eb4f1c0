/** The pages for teachers: they load their own files, and start a simulator only where one is used. */
import "../ui/base.css";
import "../ui/fonts/inter.css";
import { I18nextProvider } from "react-i18next";
import { startServiceWorker } from "../features/offline/service-worker.ts";
import type { TeachSlots } from "../features/teach/frame/teach-slots.ts";
import { TeachPage } from "../features/teach/TeachPage.tsx";
import { LanguageProvider } from "../model/language-context.ts";
import type { PageParts } from "../model/page-parts.ts";
import { lazyPart } from "../ui/lazy-part.tsx";
import type { SurroundingPage } from "./student-page.ts";

const LessonWorkbench = lazyPart(
  async () => (await import("./LessonWorkbench.tsx")).LessonWorkbench,
);
const StudentTrial = lazyPart(async () => (await import("./StudentTrial.tsx")).StudentTrial);

export async function openPage(parts: PageParts): Promise<void> {
  const { root, words, language, screen, device, tools } = parts;
  await words.loadNamespaces(["teach", "check", "report", "lessonEditor"]);
  root.render(
    <I18nextProvider i18n={words}>
      <LanguageProvider value={language}>
        <TeachPage device={device} tools={tools} slots={slotsOf({ words, screen, device })} />
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

function slotsOf(page: SurroundingPage): TeachSlots {
  return {
    Workbench: (props) => <LessonWorkbench {...props} page={page} />,
    Trial: (props) => <StudentTrial {...props} page={page} />,
  };
}
