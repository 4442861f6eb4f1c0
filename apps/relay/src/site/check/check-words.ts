/**
 * The texts of /check in eight languages. They are separate from the simulator's texts: the page also
 * works if the network blocks the simulator, and from a relay without a built page.
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

/**
 * Renders the page in one language.
 * @param host the host name of the service as the visitor knows it
 */
export function checkPage(html: string, lang: string, host: string): string {
  const words = checkWords.get(lang) ?? checkWords.get("en") ?? {};
  const intro = words["intro"]?.replace("{{host}}", () => host) ?? "";
  const texts: CheckWords = { ...words, intro, lang, dir: lang === "ar" ? "rtl" : "ltr" };
  return html.replaceAll(/\{\{(\w+)\}\}/g, (_all, name: string) =>
    // In a script element only "<" must be escaped. All other texts are HTML text.
    name === "words"
      ? JSON.stringify(texts).replaceAll("<", "\\u003c")
      : escaped(texts[name] ?? ""),
  );
}

function escaped(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");
}
