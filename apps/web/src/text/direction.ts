/** The writing direction of a language that is not necessarily one of the page. */

// cspell:ignore Adlm Hebr Mand Nkoo Rohg Syrc Thaa
/** ISO 15924 codes of the scripts in use that are written from right to left. */
const RIGHT_TO_LEFT = new Set(["Adlm", "Arab", "Hebr", "Mand", "Nkoo", "Rohg", "Syrc", "Thaa"]);

/**
 * @param tag BCP 47 tag; null if the language is unknown
 * @returns the value of the attribute `dir`; `auto`, by the first letter, if the tag is unknown
 */
export function directionOf(tag: string | null): "ltr" | "rtl" | "auto" {
  if (tag === null) return "auto";
  try {
    const { script } = new Intl.Locale(tag).maximize();
    return script === undefined ? "auto" : RIGHT_TO_LEFT.has(script) ? "rtl" : "ltr";
  } catch {
    return "auto";
  }
}
