/** The languages of the page, and the choice of one for a list of preferred languages. */

/** BCP 47 tags. Each name is in its own language, so that readers recognize it. */
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
  /** incomplete: only `?lang=` opens it, for its translators; menus and browsers do not */
  isDraft?: boolean;
}[];

export type LanguageTag = (typeof languages)[number]["tag"];

/** The languages that a user can choose: those with complete texts. */
export const offeredLanguages = languages.filter((each) => !("isDraft" in each));

/** The languages in the menu: the complete ones and the displayed one. */
export function listedLanguages(shown: LanguageTag): readonly (typeof languages)[number][] {
  return languages.filter((each) => !("isDraft" in each) || each.tag === shown);
}

export function languageOf(tag: LanguageTag): (typeof languages)[number] {
  const found = languages.find((each) => each.tag === tag);
  if (found === undefined) throw new Error(`no language ${tag}`);
  return found;
}

/**
 * The first preferred language that is available. "de" matches "de-AT" and "zh-Hans" matches "zh-CN",
 * but not "zh-TW", which uses another script.
 * @param wanted BCP 47 tags by preference; invalid tags are ignored
 * @param among the available tags
 * @returns null if none matches
 */
export function matchLanguage<Tag extends string>(
  wanted: readonly string[],
  among: readonly Tag[],
): Tag | null {
  for (const tag of wanted) {
    // "en-GB" matches "en" without Intl, whose initialization takes 3 ms.
    const plain = /^([a-z]{2})(?:-[A-Z]{2})?$/.exec(tag)?.[1];
    const own = among.find((each) => each === plain);
    if (own !== undefined) return own;
    const writing = writingOf(tag);
    const found = among.find((each) => writing !== null && writingOf(each) === writing);
    if (found !== undefined) return found;
  }
  return null;
}

/** Language and script, such as "zh-Hans"; null for an invalid tag. */
function writingOf(tag: string): string | null {
  try {
    const { language, script } = new Intl.Locale(tag).maximize();
    return `${language}-${script ?? ""}`;
  } catch {
    return null;
  }
}
