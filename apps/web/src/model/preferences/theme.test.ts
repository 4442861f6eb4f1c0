import { readFileSync } from "node:fs";
import { runInNewContext } from "node:vm";
import { describe, expect, it } from "vitest";
import { createScreenStore } from "../screen/screen-store.ts";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { startTheme } from "./theme.ts";

/** A media query that tests switch. */
class Query {
  matches: boolean;
  readonly #listeners: (() => void)[] = [];

  constructor(matches: boolean) {
    this.matches = matches;
  }

  addEventListener(_type: "change", listener: () => void): void {
    this.#listeners.push(listener);
  }

  turn(matches: boolean): void {
    this.matches = matches;
    for (const listener of this.#listeners) listener();
  }
}

interface Given {
  stored?: string;
  storedContrast?: string;
  isSystemDark?: boolean;
  asksForContrast?: boolean;
}

function openPage({ stored, storedContrast, isSystemDark, asksForContrast }: Given) {
  const storage = new MemoryStorage();
  if (stored !== undefined) storage.setItem("corridor.theme", stored);
  if (storedContrast !== undefined) storage.setItem("corridor.contrast", storedContrast);
  const screen = createScreenStore();
  const shown: string[] = [];
  const systemDark = new Query(isSystemDark ?? false);
  const systemContrast = new Query(asksForContrast ?? false);
  startTheme({
    screen,
    storage,
    systemDark,
    systemContrast,
    apply: ({ theme, contrast }) => void shown.push(`${theme} ${contrast}`),
  });
  return { screen, storage, shown, systemDark, systemContrast };
}

const cases: (Given & { shown: string })[] = [
  { shown: "light normal" },
  { isSystemDark: true, shown: "dark normal" },
  { stored: "light", isSystemDark: true, shown: "light normal" },
  { stored: "dark", shown: "dark normal" },
  { stored: "system", isSystemDark: true, shown: "dark normal" },
  { stored: "nonsense", shown: "light normal" },
  { storedContrast: "more", shown: "light more" },
  { storedContrast: "more", stored: "dark", shown: "dark more" },
  { storedContrast: "system", asksForContrast: true, shown: "light more" },
  { storedContrast: "nonsense", shown: "light normal" },
  { asksForContrast: true, isSystemDark: true, shown: "dark more" },
];

describe("the theme", () => {
  it.each(cases)(
    "is $shown, given $stored, $storedContrast, $isSystemDark, $asksForContrast",
    (given) => {
      expect(openPage(given).shown).toEqual([given.shown]);
    },
  );

  it.each(cases)(
    "is $shown before the first paint too, given $stored, $storedContrast, $isSystemDark, $asksForContrast",
    ({ shown, ...given }) => {
      const dataset: Record<string, string> = {};
      const stored: Record<string, string | undefined> = {
        "corridor.theme": given.stored,
        "corridor.contrast": given.storedContrast,
      };
      const requests: Record<string, boolean | undefined> = {
        "(prefers-color-scheme: dark)": given.isSystemDark,
        "(prefers-contrast: more)": given.asksForContrast,
      };
      runInNewContext(readFileSync(new URL("../../../public/first.js", import.meta.url), "utf8"), {
        localStorage: { getItem: (key: string) => stored[key] ?? null },
        matchMedia: (query: string) => ({ matches: requests[query] ?? false }),
        document: { documentElement: { dataset }, currentScript: { dataset: {} } },
        window: {},
        addEventListener: () => undefined,
        URLSearchParams,
        location: { pathname: "/", search: "" },
        navigator: { languages: ["en"] },
      });
      expect(`${dataset["theme"]} ${dataset["contrast"]}`).toBe(shown);
    },
  );

  it("follows the user's choice and stores it", () => {
    const page = openPage({});
    page.screen.setState({ theme: "dark" });
    expect(page.shown.at(-1)).toBe("dark normal");
    page.screen.setState({ contrast: "more" });
    expect(page.shown.at(-1)).toBe("dark more");
    expect(page.storage.getItem("corridor.theme")).toBe("dark");
    expect(page.storage.getItem("corridor.contrast")).toBe("more");
  });

  it("follows the system only while the user has not chosen", () => {
    const page = openPage({});
    page.systemDark.turn(true);
    expect(page.shown.at(-1)).toBe("dark normal");
    page.screen.setState({ theme: "light" });
    page.systemDark.turn(false);
    page.systemDark.turn(true);
    expect(page.shown.at(-1)).toBe("light normal");
  });

  it("gives more contrast whenever the system requests it", () => {
    const page = openPage({ stored: "light" });
    page.systemContrast.turn(true);
    expect(page.shown.at(-1)).toBe("light more");
    page.systemContrast.turn(false);
    expect(page.shown.at(-1)).toBe("light normal");
  });
});
