/** Entry of the page: starts the worker, builds the services, mounts React. */
import { createRoot } from "react-dom/client";
import { I18nextProvider } from "react-i18next";
import { App } from "./app/App.tsx";
import { flushWhenHidden } from "./app/autosave.ts";
import { createServices, ServicesProvider } from "./app/services.ts";
import { keepSingleKeys } from "./app/single-keys.ts";
import { startTheme } from "./app/theme.ts";
import { followAddress } from "./app/url-sync.ts";
import { storageOrNone } from "./app/works.ts";
import { openEmptyMaze } from "./features/works/empty-maze.ts";
import { createI18n } from "./text/i18n.ts";

const words = createI18n();
const device = storageOrNone(() => localStorage);
const worker = new Worker(new URL("./worker/simulator.worker.ts", import.meta.url), {
  type: "module",
});
const services = createServices({
  worker,
  device,
  tab: storageOrNone(() => sessionStorage),
  words,
});

// A worker that does not load or breaks outside of its own care says so here only.
worker.onerror = ({ message }) => {
  services.run.setState({ fault: message || words.t("shell.failure.notLoaded") });
};

startTheme({
  screen: services.screen,
  storage: device,
  systemDark: matchMedia("(prefers-color-scheme: dark)"),
  apply: (theme) => (document.documentElement.dataset["theme"] = theme),
});
keepSingleKeys(services.screen, device);
flushWhenHidden(services.works.autosave, {
  isHidden: () => document.visibilityState === "hidden",
  listen: (type, listener) => {
    (type === "pagehide" ? window : document).addEventListener(type, listener);
  },
});

function follow(): void {
  followAddress({
    ...services,
    words,
    maze: () => services.workspace.getState().maze,
    location,
    replaceAddress: (address) => history.replaceState(history.state, "", address),
    openEmptyMaze: () => openEmptyMaze(services, words),
  });
}
follow();
window.addEventListener("hashchange", follow);

const root = document.getElementById("root");
if (root === null) throw new Error("index.html has no #root");
createRoot(root).render(
  <I18nextProvider i18n={words}>
    <ServicesProvider value={services}>
      <App />
    </ServicesProvider>
  </I18nextProvider>,
);
