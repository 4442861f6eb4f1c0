import { readFileSync } from "node:fs";
import { runInNewContext } from "node:vm";
import { describe, expect, it } from "vitest";
import { createScreenStore } from "../stores/screen-store.ts";
import { MemoryStorage } from "./testing/memory-storage.ts";
import { startTheme } from "./theme.ts";

/** A wish of the system, which tests turn on and off. */
class Wish {
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
  kept?: string;
  keptContrast?: string;
  isSystemDark?: boolean;
  asksForContrast?: boolean;
}

function openPage({ kept, keptContrast, isSystemDark, asksForContrast }: Given) {
  const storage = new MemoryStorage();
  if (kept !== undefined) storage.setItem("corridor.theme", kept);
  if (keptContrast !== undefined) storage.setItem("corridor.contrast", keptContrast);
  const screen = createScreenStore();
  const shown: string[] = [];
  const systemDark = new Wish(isSystemDark ?? false);
  const systemContrast = new Wish(asksForContrast ?? false);
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
  { kept: "light", isSystemDark: true, shown: "light normal" },
  { kept: "dark", shown: "dark normal" },
  { kept: "system", isSystemDark: true, shown: "dark normal" },
  { kept: "nonsense", shown: "light normal" },
  { keptContrast: "more", shown: "light more" },
  { keptContrast: "more", kept: "dark", shown: "dark more" },
  { keptContrast: "system", asksForContrast: true, shown: "light more" },
  { keptContrast: "nonsense", shown: "light normal" },
  { asksForContrast: true, isSystemDark: true, shown: "dark more" },
];

describe("the theme", () => {
  it.each(cases)(
    "is $shown, given $kept, $keptContrast, $isSystemDark, $asksForContrast",
    (given) => {
      expect(openPage(given).shown).toEqual([given.shown]);
    },
  );

  it.each(cases)(
    "is $shown before the first paint too, given $kept, $keptContrast, $isSystemDark, $asksForContrast",
    ({ shown, ...given }) => {
      const dataset: Record<string, string> = {};
      const kept: Record<string, string | undefined> = {
        "corridor.theme": given.kept,
        "corridor.contrast": given.keptContrast,
      };
      const wishes: Record<string, boolean | undefined> = {
        "(prefers-color-scheme: dark)": given.isSystemDark,
        "(prefers-contrast: more)": given.asksForContrast,
      };
      runInNewContext(readFileSync(new URL("../../public/first.js", import.meta.url), "utf8"), {
        localStorage: { getItem: (key: string) => kept[key] ?? null },
        matchMedia: (query: string) => ({ matches: wishes[query] ?? false }),
        document: { documentElement: { dataset }, currentScript: { dataset: {} } },
        window: {},
        addEventListener: () => undefined,
        URLSearchParams,
        location: { search: "" },
        navigator: { languages: ["en"] },
      });
      expect(`${dataset["theme"]} ${dataset["contrast"]}`).toBe(shown);
    },
  );

  it("follows the reader's choice and keeps it", () => {
    const page = openPage({});
    page.screen.setState({ theme: "dark" });
    expect(page.shown.at(-1)).toBe("dark normal");
    page.screen.setState({ contrast: "more" });
    expect(page.shown.at(-1)).toBe("dark more");
    expect(page.storage.getItem("corridor.theme")).toBe("dark");
    expect(page.storage.getItem("corridor.contrast")).toBe("more");
  });

  it("follows the system only while the reader has not decided", () => {
    const page = openPage({});
    page.systemDark.turn(true);
    expect(page.shown.at(-1)).toBe("dark normal");
    page.screen.setState({ theme: "light" });
    page.systemDark.turn(false);
    page.systemDark.turn(true);
    expect(page.shown.at(-1)).toBe("light normal");
  });

  it("gives more contrast whenever the system asks for it", () => {
    const page = openPage({ kept: "light" });
    page.systemContrast.turn(true);
    expect(page.shown.at(-1)).toBe("light more");
    page.systemContrast.turn(false);
    expect(page.shown.at(-1)).toBe("light normal");
  });
});
