import { readFileSync } from "node:fs";
import { runInNewContext } from "node:vm";
import { describe, expect, it } from "vitest";
import { createScreenStore } from "../stores/screen-store.ts";
import { MemoryStorage } from "./testing/memory-storage.ts";
import { startTheme } from "./theme.ts";

function openPage({ kept, isSystemDark }: { kept: string | null; isSystemDark: boolean }) {
  const storage = new MemoryStorage();
  if (kept !== null) storage.setItem("corridor.theme", kept);
  const screen = createScreenStore();
  const shown: string[] = [];
  const system = { matches: isSystemDark, listeners: [] as (() => void)[] };
  startTheme({
    screen,
    storage,
    systemDark: {
      get matches() {
        return system.matches;
      },
      addEventListener: (_type, listener) => void system.listeners.push(listener),
    },
    apply: (theme) => void shown.push(theme),
  });
  const turnSystem = (isDark: boolean) => {
    system.matches = isDark;
    for (const listener of system.listeners) listener();
  };
  return { screen, storage, shown, turnSystem };
}

const cases = [
  { kept: null, isSystemDark: false, theme: "light" },
  { kept: null, isSystemDark: true, theme: "dark" },
  { kept: "light", isSystemDark: true, theme: "light" },
  { kept: "dark", isSystemDark: false, theme: "dark" },
  { kept: "system", isSystemDark: true, theme: "dark" },
  { kept: "nonsense", isSystemDark: false, theme: "light" },
];

describe("the theme", () => {
  it.each(cases)("is $theme when $kept was kept and the system is dark: $isSystemDark", (given) => {
    expect(openPage(given).shown).toEqual([given.theme]);
  });

  it.each(cases)(
    "is $theme before the first paint too, when $kept was kept and the system is dark: $isSystemDark",
    ({ kept, isSystemDark, theme }) => {
      const dataset: Record<string, string> = {};
      runInNewContext(readFileSync(new URL("../../public/theme.js", import.meta.url), "utf8"), {
        localStorage: { getItem: (key: string) => (key === "corridor.theme" ? kept : null) },
        matchMedia: () => ({ matches: isSystemDark }),
        document: { documentElement: { dataset } },
      });
      expect(dataset).toEqual({ theme });
    },
  );

  it("follows the reader's choice and keeps it", () => {
    const page = openPage({ kept: null, isSystemDark: false });
    page.screen.setState({ theme: "dark" });
    expect(page.shown.at(-1)).toBe("dark");
    expect(page.storage.getItem("corridor.theme")).toBe("dark");
  });

  it("follows the system only while the reader has not decided", () => {
    const page = openPage({ kept: null, isSystemDark: false });
    page.turnSystem(true);
    expect(page.shown.at(-1)).toBe("dark");
    page.screen.setState({ theme: "light" });
    page.turnSystem(false);
    page.turnSystem(true);
    expect(page.shown.at(-1)).toBe("light");
  });
});
