import type { LanguageTag } from "../../text/languages.ts";

/** The language's code for the top bar: "EN", "ZH". It omits script and country. */
export function shortName(tag: LanguageTag): string {
  return (tag.split("-")[0] ?? tag).toUpperCase();
}
