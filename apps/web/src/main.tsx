/** Entry of the page: builds the services, mounts React. */
import type { i18n } from "i18next";
import { startTransition } from "react";
import { createRoot } from "react-dom/client";
import { I18nextProvider } from "react-i18next";
import { App } from "./shell/App.tsx";
import { flushWhenHidden, type PageLife } from "./model/projects/autosave.ts";
import { browserLanguage } from "./shell/boot/browser-language.ts";
import type { LanguageChoice } from "./model/preferences/language.ts";
import { LanguageProvider } from "./model/language-context.ts";
import { guardLeaving } from "./shell/boot/guard-leaving.ts";
import { storeSwitches } from "./model/preferences/stored-switches.ts";
import { createServices } from "./shell/create-services.ts";
import { ServicesProvider } from "./model/use-services.ts";
import { whenIdle } from "./shell/boot/page-idle.ts";
import { earlyMessages, onSimulatorFailure, startSimulator } from "./shell/boot/simulator-start.ts";
import { replaceStaticPage } from "./shell/boot/replace-static-page.ts";
import { startTheme } from "./model/preferences/theme.ts";
import { ProjectReader } from "./model/projects/project-reader.ts";
import { ProjectStorage } from "./model/projects/project-storage.ts";
import { storageOrNone } from "./model/storage/key-value-storage.ts";
import { CLASS_KEY } from "./model/classes/class-key.ts";
import { RACE_KEY } from "./model/run/race-store.ts";
import { createScreenStore, showMessage } from "./model/screen/screen-store.ts";
import { englishWords } from "./text/english-words.ts";
import { createI18n } from "./text/i18n.ts";
import { preloadParts } from "./ui/lazy-part.tsx";

declare global {
  interface Window {
    /** says that the page cannot open, in other words than its own English ones if need be; of public/first.js */
    corridorFailed: (...words: [title: string, text: string, retry: string] | []) => undefined;
  }
}

/** The paths of pages without a robot. */
const OTHER_PAGE = /^\/(r\/|join|teach|embed|class)/;
/** A little more than a sixtieth of a second: the next frame has begun then. */
const FRAME_MS = 17;

const device = storageOrNone(() => localStorage);
const tab = storageOrNone(() => sessionStorage);
const worker = startSimulator();
const reader = new ProjectReader();
const screen = createScreenStore();

const container = requireContainer();
const root = createRoot(container);

async function start(): Promise<void> {
  const english = await englishWords().catch(() => window.corridorFailed());
  if (english === undefined) return;
  const words = createI18n(english);
  const language = browserLanguage(words, screen, device);
  // Load the user's language before anything is displayed.
  await language.start();
  startTheme({
    screen,
    storage: device,
    systemDark: matchMedia("(prefers-color-scheme: dark)"),
    systemContrast: matchMedia("(prefers-contrast: more)"),
    apply: (shown) => Object.assign(document.documentElement.dataset, shown),
  });
  const path = location.pathname;
  if (OTHER_PAGE.test(path)) {
    return import("./shell/other-pages.tsx")
      .then(({ openOtherPage }) => openOtherPage(path, { root, words, language, screen, device }))
      .catch(() => window.corridorFailed());
  }
  // Load what this visit needs before the first paint. Most first visits need nothing.
  try {
    if (!new ProjectStorage(device, () => null).isEmpty) await reader.load();
  } catch {
    // Without its reader all stored work would be out of sight: better no page than an empty one.
    const { t } = words;
    window.corridorFailed(
      t("offline.pageFailedTitle"),
      t("offline.pageFailed"),
      t("offline.tryAgain"),
    );
    return;
  }
  await open(words, language);
}

async function open(words: i18n, language: LanguageChoice): Promise<void> {
  const services = createServices({
    worker,
    device,
    tab,
    words,
    screen,
    reader,
    nextFrame: (task) => setTimeout(task, FRAME_MS),
  });
  services.simulator.catchUp(earlyMessages());

  onSimulatorFailure(worker, (reason) => {
    services.simulator.fail(reason || words.t("shell.failure.notLoaded"));
  });

  storeSwitches(screen, device);
  const flush = () => {
    services.projects.autosave.flush();
    services.restorer.flush();
  };
  const life: PageLife = {
    isHidden: () => document.visibilityState === "hidden",
    listen: (type, listener) => {
      (type === "pagehide" ? window : document).addEventListener(type, listener);
    },
  };
  flushWhenHidden({ flush }, life);
  guardLeaving(screen, window);

  const isAsked = () => location.hash.length > 1 || location.pathname.startsWith("/m/");
  const follow = async (isLoad: boolean): Promise<void> => {
    if (!isAsked()) return;
    try {
      const { followPageAddress } = await import("./shell/follow-page-address.ts");
      await followPageAddress(services, words, isLoad);
    } catch {
      showMessage(screen, { tone: "bad", text: words.t("offline.linkFailed") });
    }
  };
  window.addEventListener("online", () => services.connection.reconnect());
  window.addEventListener("hashchange", () => void follow(false));

  screen.setState({ isOpening: isAsked() });
  const hasExtras =
    tab.getItem(CLASS_KEY) ?? device.getItem("corridor.sound") ?? tab.getItem(RACE_KEY);
  // Files that do not come leave the page without them.
  const extras =
    hasExtras === null
      ? null
      : import("./shell/boot/open-extras.ts")
          .then(({ openExtras }) => openExtras(services, words, tab))
          .catch(() => null);
  const page = (
    <I18nextProvider i18n={words}>
      <ServicesProvider value={services}>
        <LanguageProvider value={language}>
          <App />
        </LanguageProvider>
      </ServicesProvider>
    </I18nextProvider>
  );
  // React renders in slices of 5 ms, so that the static page of index.html stays responsive.
  await replaceStaticPage(container, () => startTransition(() => root.render(page)));

  // The page appears before the content of its address: a link may take long or never load.
  void follow(true).then(async () => {
    screen.setState({ isOpening: false });
    // A pause of the class must be known before a script's robot drives again.
    const resumeExtras = await extras;
    void services.restorer.resume().then(() => {
      services.connection.resume();
      void services.lessons.handOver();
      void resumeExtras?.();
    });
  });

  await whenIdle(services.run);
  await Promise.allSettled([reader.load(), preloadParts()]);
  if (!import.meta.env.PROD) return;
  try {
    const { offerUpdates } = await import("./features/offline/offer-update.ts");
    await offerUpdates(services, words, () => location.reload());
  } catch {
    // Private windows and full storages refuse a service worker: the page needs a network, as before.
  }
}

function requireContainer(): HTMLElement {
  const element = document.getElementById("root");
  if (element === null) throw new Error("index.html has no #root");
  return element;
}

void start();
