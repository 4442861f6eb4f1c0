/** The pages of a running class: the dashboard of its teacher, or a big screen. */
import "../../ui/base.css";
import "../../ui/fonts/inter.css";
import { I18nextProvider } from "react-i18next";
import {
  hasClassKey,
  takeClassVisit,
  type ClassVisit,
} from "../../model/classroom/class-address.ts";
import { OwnClasses } from "../../model/classroom/own-classes.ts";
import { LanguageProvider } from "../../model/language-context.ts";
import type { PageParts } from "../../model/page-parts.ts";
import { storageOrNone } from "../../model/storage/key-value-storage.ts";
import { SavedReports } from "../../model/teaching/saved-reports.ts";
import { BrokenAddress } from "./BrokenAddress.tsx";

export async function openPage(parts: PageParts): Promise<void> {
  const { root, words, language, device, tools } = parts;
  const now = (): number => Date.now();
  const classes = new OwnClasses(device, now);
  const tab = storageOrNone(() => sessionStorage);
  const read = (): ClassVisit =>
    takeClassVisit({
      location,
      classes,
      tab,
      replaceAddress: (address) => history.replaceState(history.state, "", address),
      now,
    });
  // First of all: removes the key from the visible address.
  const visit = read();
  // Another link to the same class in the address bar does not reload the page.
  window.addEventListener("hashchange", () => {
    if (hasClassKey(location.hash)) location.reload();
    else if (location.hash.length > 1) read();
  });
  await words.loadNamespaces(["dashboard", "names"]);
  const page = await pageOf(visit, parts, classes);
  root.render(
    <I18nextProvider i18n={words}>
      <LanguageProvider value={language}>
        {page ?? <BrokenAddress tools={tools} />}
      </LanguageProvider>
    </I18nextProvider>,
  );
}

async function pageOf(visit: ClassVisit, parts: PageParts, classes: OwnClasses) {
  const { words, tools, device } = parts;
  switch (visit.kind) {
    case "teach": {
      const { openDashboard } = await import("./open-dashboard.tsx");
      return openDashboard({
        room: visit.room,
        classes,
        reports: new SavedReports(device),
        words,
        tools,
      });
    }
    case "show": {
      const { openBigScreen } = await import("./open-big-screen.tsx");
      return openBigScreen({ id: visit.id, key: visit.key, tools });
    }
    case "broken":
      return null;
  }
}
