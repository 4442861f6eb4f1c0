/**
 * The words of /check in eight languages. They stand here and not with the simulator's: the page has to
 * work where the simulator does not come through, from a relay that was set up without it.
 */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

const FOLDER = join(import.meta.dirname, "words");

export type CheckWords = Record<string, string>;

/** By language, such as "de" or "zh-Hans". */
export const checkWords: ReadonlyMap<string, CheckWords> = new Map(
  readdirSync(FOLDER).map((file) => [
    file.replace(".json", ""),
    JSON.parse(readFileSync(join(FOLDER, file), "utf8")) as CheckWords,
  ]),
);

/** The page in one language. @param host the service as its visitor knows it */
export function checkPage(html: string, lang: string, host: string): string {
  const words = checkWords.get(lang) ?? checkWords.get("en") ?? {};
  const intro = words["intro"]?.replace("{{host}}", () => host) ?? "";
  const texts: CheckWords = { ...words, intro, lang, dir: lang === "ar" ? "rtl" : "ltr" };
  return html.replaceAll(/\{\{(\w+)\}\}/g, (_all, name: string) =>
    // Inside of a script element only "<" can end it; everywhere else these texts are plain.
    name === "words"
      ? JSON.stringify(texts).replaceAll("<", "\\u003c")
      : escaped(texts[name] ?? ""),
  );
}

function escaped(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");
}
