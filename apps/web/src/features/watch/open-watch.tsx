/**
 * The page of a viewer: it displays the robot of the address, live and read-only. It loads its own
 * files, and starts no simulator.
 */
import "../../ui/base.css";
import "../../ui/fonts/inter.css";
import { I18nextProvider } from "react-i18next";
import { LanguageProvider } from "../../model/language-context.ts";
import type { PageParts } from "../../model/page-parts.ts";
import { storageOrNone } from "../../model/storage/key-value-storage.ts";
import { takeVisit, type Visit } from "./watch-address.ts";
import { WatchClient } from "./watch-client.ts";
import { createWatchStore, nothingYet } from "./watch-store.ts";
import { WatchPage } from "./WatchPage.tsx";

export async function openPage({ root, words, language, tools }: PageParts): Promise<void> {
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
