/** The language's code as the top bar shows it. */
import type { LanguageTag } from "../../text/languages.ts";

/** "EN", "ZH": the language alone, without script or country. */
export function shortName(tag: LanguageTag): string {
  return (tag.split("-")[0] ?? tag).toUpperCase();
}
