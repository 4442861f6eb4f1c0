import { describe, expect, it } from "vitest";
import { en } from "../text/en/index.ts";
import { createI18n, showLanguage } from "../text/i18n.ts";
import type { LanguageTag } from "../text/languages.ts";
import { capsOf } from "./key-caps.ts";

async function capsIn(tag: LanguageTag, keys: string, isMac = false): Promise<string> {
  const words = createI18n(en);
  await showLanguage(words, tag);
  return capsOf(words.t, keys, isMac);
}

describe("the keys of the list", () => {
  it.each([
    ["en", "Space", "Space"],
    ["de", "Space", "Leertaste"],
    ["de", "Ctrl+Shift+Z", "Strg+Umschalt+Z"],
    ["de", "Delete", "Entf"],
    ["fr", "Esc", "Échap"],
    ["fr", "Delete", "Suppr"],
    ["es", "Space", "Espacio"],
    ["pt", "Space", "Espaço"],
    ["ja", "Space", "スペース"],
    ["ar", "Space", "مسافة"],
    ["zh-Hans", "Alt+↑", "Alt+↑"],
    ["fr", "?", "?"],
  ] as const)("in %s: %s is printed as %s", async (tag, keys, caps) => {
    expect(await capsIn(tag, keys)).toBe(caps);
  });

  it("have a Mac's signs on a Mac, in every language", async () => {
    expect(await capsIn("de", "Ctrl+Shift+Enter", true)).toBe("⌘+⇧+Eingabe");
    expect(await capsIn("fr", "Alt+↓", true)).toBe("⌥+↓");
  });
});
