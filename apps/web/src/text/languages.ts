/** The languages of the page, and which of them fits what a reader asks for. */

/** Tags are BCP 47. Names are in the language itself, so that readers find their own. */
export const languages = [
  { tag: "en", name: "English", dir: "ltr" },
  { tag: "ar", name: "العربية", dir: "rtl" },
  { tag: "de", name: "Deutsch", dir: "ltr" },
  { tag: "es", name: "Español", dir: "ltr" },
  { tag: "fr", name: "Français", dir: "ltr" },
  { tag: "ja", name: "日本語", dir: "ltr" },
  { tag: "pt", name: "Português", dir: "ltr" },
  { tag: "zh-Hans", name: "简体中文", dir: "ltr" },
] as const satisfies readonly {
  tag: string;
  name: string;
  dir: "ltr" | "rtl";
  /** still being translated: `?lang=` opens it for its translators, no menu and no browser does */
  isDraft?: boolean;
}[];

export type LanguageTag = (typeof languages)[number]["tag"];

/** What a reader can choose: the languages whose words are complete. */
export const offeredLanguages = languages.filter((each) => !("isDraft" in each));

/** The languages that a menu lists: those that are complete, and the one that is shown. */
export function listedLanguages(shown: LanguageTag): readonly (typeof languages)[number][] {
  return languages.filter((each) => !("isDraft" in each) || each.tag === shown);
}

export function languageOf(tag: LanguageTag): (typeof languages)[number] {
  const found = languages.find((each) => each.tag === tag);
  if (found === undefined) throw new Error(`no language ${tag}`);
  return found;
}

/**
 * The first wanted language that there is: "de-AT" is served by "de" and "zh-CN" by "zh-Hans", but
 * "zh-TW" is not, since its readers read another script.
 * @param wanted BCP 47 tags, the dearest first; ones that are none are passed over
 * @param among the tags to choose from
 */
export function matchLanguage<Tag extends string>(
  wanted: readonly string[],
  among: readonly Tag[],
): Tag | null {
  for (const tag of wanted) {
    // "en-GB" is English, wherever that is read: only the rest asks Intl, which takes 3 ms to wake.
    const plain = /^([a-z]{2})(?:-[A-Z]{2})?$/.exec(tag)?.[1];
    const own = among.find((each) => each === plain);
    if (own !== undefined) return own;
    const writing = writingOf(tag);
    const found = among.find((each) => writing !== null && writingOf(each) === writing);
    if (found !== undefined) return found;
  }
  return null;
}

/** Language and script, such as "zh-Hans"; null for what is no tag. */
function writingOf(tag: string): string | null {
  try {
    const { language, script } = new Intl.Locale(tag).maximize();
    return `${language}-${script ?? ""}`;
  } catch {
    return null;
  }
}
