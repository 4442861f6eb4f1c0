/** The page on which a student joins a class. It loads its own files, and starts no simulator. */
import "../../ui/base.css";
import "../../ui/fonts/inter.css";
import { I18nextProvider } from "react-i18next";
import { LanguageProvider } from "../../model/language-context.ts";
import type { PageParts } from "../../model/page-parts.ts";
import { storageOrNone } from "../../model/storage/key-value-storage.ts";
import { JoinPage } from "./JoinPage.tsx";

export async function openPage({ root, words, language, tools }: PageParts): Promise<void> {
  const tab = storageOrNone(() => sessionStorage);
  await words.loadNamespaces(["join", "names"]);
  root.render(
    <I18nextProvider i18n={words}>
      <LanguageProvider value={language}>
        <JoinPage tab={tab} tools={tools} />
      </LanguageProvider>
    </I18nextProvider>,
  );
}
