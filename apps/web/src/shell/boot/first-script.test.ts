import { readFileSync } from "node:fs";
import { runInNewContext } from "node:vm";
import { describe, expect, it } from "vitest";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n, showLanguage, shownLanguage } from "../../text/i18n.ts";
import { languages } from "../../text/languages.ts";
import { earlyProject } from "../../simulator/protocol/first-project.ts";
import { firstWords } from "../../../build/first-script.ts";
import { firstProject } from "../../model/projects/first-visit.ts";
import { LanguageChoice } from "../../model/preferences/language.ts";
import { MemoryStorage } from "../../model/storage/testing/memory-storage.ts";

interface Visit {
  pathname?: string;
  search?: string;
  hash?: string;
  /** on the device */
  stored?: Record<string, string>;
  /** in the tab */
  tab?: Record<string, string>;
  preferred?: readonly string[];
}

const script = readFileSync(new URL("../../../public/first.js", import.meta.url), "utf8");
const words = Object.fromEntries(languages.map(({ tag }) => [tag, firstWords(tag)]));

/** Runs `public/first.js` as index.html does, until the static page is complete. */
function open({
  pathname = "/",
  search = "",
  hash = "",
  stored = {},
  tab = {},
  preferred = ["en"],
}: Visit) {
  const root = { dataset: {} as { first?: string }, lang: "", dir: "" };
  const names: string[] = [];
  const said: Record<string, string> = {};
  const places = ["run", "invitation", "begin"].map((word) => ({
    dataset: { word },
    append: (text: string) => (said[word] = text),
  }));
  const timers: (() => void)[] = [];
  let fetched = 0;
  let houseIsThere = () => {};
  const storage = (items: Record<string, string>) =>
    Object.defineProperty({ ...items }, "getItem", {
      value: (key: string) => items[key] ?? null,
    });
  runInNewContext(script, {
    document: {
      documentElement: root,
      head: { append: () => (fetched += 1) },
      currentScript: {
        dataset: { words: JSON.stringify(words), simulator: "/worker.js", page: "/page.js" },
      },
      addEventListener: () => undefined,
      getElementById: () => ({}),
      querySelector: () => ({ setAttribute: () => undefined }),
      querySelectorAll: (wanted: string) => (wanted === "[data-word]" ? places : []),
    },
    window: {},
    setTimeout: (action: () => void) => timers.push(action),
    location: { pathname, search, hash },
    navigator: { languages: preferred },
    localStorage: storage(stored),
    sessionStorage: storage(tab),
    matchMedia: () => ({ matches: false }),
    URLSearchParams,
    Worker: class {
      constructor(_address: string, { name }: { name: string }) {
        names.push(name);
      }
    },
    MutationObserver: class {
      constructor(notice: () => void) {
        houseIsThere = notice;
      }
      observe(): void {}
      disconnect(): void {}
    },
  });
  const fetchedAtOnce = fetched > 0;
  houseIsThere();
  for (const timer of timers) timer();
  return { root, name: names[0] ?? "", said, fetchedAtOnce, fetchedLater: fetched > 0 };
}

describe("a first visit", () => {
  it.each(languages)(
    "starts in the worker with the page's own project, in $name",
    async ({ tag }) => {
      const i18n = createI18n(en);
      await showLanguage(i18n, tag);
      expect(earlyProject(open({ search: `?lang=${tag}` }).name)).toEqual(firstProject(i18n));
    },
  );

  it.each<Visit & { what: string }>([
    { what: "a project is stored", stored: { "corridor.work.a": "{}" } },
    { what: "a project that cannot be read is stored", stored: { "corridor.aside.a": "{}" } },
    { what: "a run was reloaded", tab: { "corridor.run": "12" } },
    { what: "the address has a link", hash: "#abc" },
    { what: "the address is a robot's", pathname: "/r/robot" },
    { what: "the page is in a frame", pathname: "/embed" },
    { what: "the address is a short link", pathname: "/m/AAAAAAAAAAAA" },
  ])("is none where $what: the worker waits for the page", (visit) => {
    expect(earlyProject(open(visit).name)).toBeNull();
  });

  it("fetches the page's script after the worker's start, later visits at once", () => {
    expect(open({})).toMatchObject({ fetchedAtOnce: false, fetchedLater: true });
    expect(open({ hash: "#abc" })).toMatchObject({ fetchedAtOnce: true });
  });

  it("is also one if the user has only chosen a theme", () => {
    expect(earlyProject(open({ stored: { "corridor.theme": "dark" } }).name)).not.toBeNull();
  });
});

describe("the invitation before the page's script", () => {
  it.each(languages)("shows the same text as the page, in $name", async ({ tag }) => {
    const i18n = createI18n(en);
    await showLanguage(i18n, tag);
    const { root, said } = open({ search: `?lang=${tag}` });
    expect(root.dataset.first).toBe("invited");
    expect(said).toMatchObject({
      invitation: i18n.t("lessons.invitation"),
      begin: i18n.t("lessons.begin"),
    });
  });

  it("is not shown to users who dismissed it or opened a lesson", () => {
    expect(open({ stored: { "corridor.lessons": "{}" } }).root.dataset.first).toBe("");
  });

  it.each<Visit>([{ stored: { "corridor.work.a": "{}" } }, { hash: "#abc" }])(
    "is not shown where the visit is not the first: %o",
    (visit) => {
      const { root, said } = open(visit);
      expect(root.dataset.first).toBeUndefined();
      expect(said).toEqual({});
    },
  );
});

describe("the language before the page's script", () => {
  it.each<Visit>([
    { preferred: ["de-AT", "en"] },
    { preferred: ["zh-TW", "zh-CN"] },
    { preferred: ["zh"] },
    { preferred: ["ar-EG", "de"] },
    { preferred: ["en-Shaw", "es-419"] },
    { preferred: ["xx", "pt-PT"] },
    { preferred: ["nl", "pt-BR"] },
    { preferred: ["nl"] },
    { preferred: ["not a tag", "ja"] },
    { preferred: ["fr"], stored: { "corridor.language": "es" } },
    { preferred: ["fr"], stored: { "corridor.language": "klingon" } },
    { preferred: ["fr"], search: "?lang=ar", stored: { "corridor.language": "es" } },
    { preferred: ["fr"], search: "?lang=nonsense" },
  ])("is the page's own: $preferred, $stored, $search", async (visit) => {
    const { preferred = [], search = "", stored = {} } = visit;
    const i18n = createI18n(en);
    const storage = new MemoryStorage();
    for (const [key, text] of Object.entries(stored)) storage.setItem(key, text);
    const applied: { tag: string; dir: string }[] = [];
    await new LanguageChoice({
      words: i18n,
      screen: createScreenStore(),
      storage,
      offered: languages.map(({ tag }) => tag),
      preferred,
      location: { pathname: "/", search, hash: "" },
      replaceAddress: () => undefined,
      apply: (shown) => applied.push(shown),
    }).start();
    const { root } = open(visit);
    expect(root).toMatchObject({ lang: shownLanguage(i18n), dir: applied.at(-1)?.dir });
  });
});
