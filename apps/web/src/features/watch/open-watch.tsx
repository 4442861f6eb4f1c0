/**
 * The page of a viewer: it displays the robot of the address, live and read-only. It loads its own
 * files, and starts no simulator.
 */
import "../../ui/base.css";
import "../../ui/fonts/inter.css";
import type { i18n } from "i18next";
import type { ReactNode } from "react";
import type { Root } from "react-dom/client";
import { I18nextProvider } from "react-i18next";
import { LanguageProvider } from "../../model/language-context.ts";
import type { LanguageChoice } from "../../model/preferences/language.ts";
import { startTheme } from "../../model/preferences/theme.ts";
import { storageOrNone, type KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import type { ScreenStore } from "../../model/screen/screen-store.ts";
import { takeVisit, type Visit } from "./watch-address.ts";
import { WatchClient } from "./watch-client.ts";
import { createWatchStore, nothingYet } from "./watch-store.ts";
import { WatchPage } from "./WatchPage.tsx";

export interface WatchParts {
  root: Pick<Root, "render">;
  /** in the language of the page */
  words: i18n;
  language: LanguageChoice;
  /** theme and contrast */
  screen: ScreenStore;
  /** localStorage, with the theme that the user has chosen */
  device: KeyValueStorage;
  /** the buttons for theme and language */
  tools: ReactNode;
}

export async function openWatch(parts: WatchParts): Promise<void> {
  const { root, words, language, screen, device, tools } = parts;
  const tab = storageOrNone(() => sessionStorage);
  const read = (): Visit =>
    takeVisit({
      location,
      tab,
      replaceAddress: (address) => history.replaceState(history.state, "", address),
    });
  // First of all: removes the key from the visible address.
  const visit = read();
  await words.loadNamespaces("watch");
  startTheme({
    screen,
    storage: device,
    systemDark: matchMedia("(prefers-color-scheme: dark)"),
    systemContrast: matchMedia("(prefers-contrast: more)"),
    apply: (shown) => Object.assign(document.documentElement.dataset, shown),
  });
  const store = createWatchStore(visit);
  let client: WatchClient | null = null;
  const begin = (next: Visit): void => {
    store.setState({ ...nothingYet, visit: next });
    if (next.kind !== "watch") return client?.stop();
    client ??= new WatchClient(startWatcher(), store);
    client.watch(next.robot);
  };
  begin(visit);
  // Another link to the same robot in the address bar does not reload the page.
  window.addEventListener("hashchange", () => {
    if (location.hash.length > 1) begin(read());
  });
  window.addEventListener("online", () => client?.tryAgain());
  root.render(
    <I18nextProvider i18n={words}>
      <LanguageProvider value={language}>
        <WatchPage store={store} tools={tools} client={() => client} />
      </LanguageProvider>
    </I18nextProvider>,
  );
}

function startWatcher(): Worker {
  return new Worker(new URL("../../simulator/watch-worker/watch.worker.ts", import.meta.url), {
    type: "module",
  });
}
