/**
 * The words of the page in a language, as its catalogues have them, and a language that nobody speaks:
 * English with accents and 40 % more letters, which finds what has no room before a translator does.
 */
import { readdirSync, readFileSync } from "node:fs";

interface Catalogue {
  [key: string]: string | Catalogue;
}

const folder = new URL("../../apps/web/src/text/", import.meta.url);

export class Words {
  readonly #catalogue: Catalogue;

  /** what stands around a value: where text runs right-to-left, the page sets values apart */
  readonly #isolate: readonly [string, string];

  private constructor(catalogue: Catalogue, isRightToLeft: boolean) {
    this.#catalogue = catalogue;
    this.#isolate = isRightToLeft ? ["\u2068", "\u2069"] : ["", ""];
  }

  /** A language of the page; what a draft lacks is in English, as on the page. */
  static of(tag: string): Words {
    const isRightToLeft = new Intl.Locale(tag).maximize().script === "Arab";
    return new Words(merged(readCatalogue("en"), readCatalogue(tag)), isRightToLeft);
  }

  static longest(): Words {
    return new Words(mapped(readCatalogue("en"), stretched), false);
  }

  /** The text of a path such as "shell.run.run", with the values of its placeholders. */
  t(path: string, values: Readonly<Record<string, string | number>> = {}): string {
    let at: string | Catalogue | undefined = this.#catalogue;
    for (const key of path.split(".")) at = typeof at === "object" ? at[key] : undefined;
    if (typeof at !== "string") throw new Error(`no text ${path}`);
    const [begin, end] = this.#isolate;
    return at.replaceAll(
      /\{\{(\w+)\}\}/g,
      (_, name: string) => `${begin}${values[name] ?? ""}${end}`,
    );
  }

  /** A module that exports all words by the names of their files, as a language's chunk does. */
  asModule(): string {
    const files = Object.entries(this.#catalogue).map(([name, words]) => [`./${name}.json`, words]);
    return `export const files = ${JSON.stringify(Object.fromEntries(files))};`;
  }
}

/** Languages that have a folder of words. */
export function languageTags(): string[] {
  return readdirSync(folder, { withFileTypes: true })
    .filter((entry) => entry.isDirectory() && entry.name !== "testing")
    .map(({ name }) => name);
}

function readCatalogue(tag: string): Catalogue {
  const files = readdirSync(new URL(`${tag}/`, folder)).filter((name) => name.endsWith(".json"));
  return Object.fromEntries(
    files.map((name) => [
      name.replace(".json", ""),
      JSON.parse(readFileSync(new URL(`${tag}/${name}`, folder), "utf8")) as Catalogue,
    ]),
  );
}

function merged(under: Catalogue, over: Catalogue): Catalogue {
  const result: Catalogue = { ...under };
  for (const [key, value] of Object.entries(over)) {
    const below = under[key];
    result[key] =
      typeof value === "object" && typeof below === "object" ? merged(below, value) : value;
  }
  return result;
}

function mapped(catalogue: Catalogue, change: (text: string) => string): Catalogue {
  return Object.fromEntries(
    Object.entries(catalogue).map(([key, value]) => [
      key,
      typeof value === "string" ? change(value) : mapped(value, change),
    ]),
  );
}

const accents: Readonly<Record<string, string>> = {
  a: "ä",
  e: "é",
  i: "ï",
  o: "ø",
  u: "ü",
  n: "ñ",
};

/** "Copy link" becomes "Cøpy lïñk łonġ". */
function stretched(text: string): string {
  const [first = "", ...rest] = text.split(/(?=\{\{)|(?<=\}\})/);
  const isPlaceholder = (part: string): boolean => part.startsWith("{{");
  const accented = [first, ...rest].map((part) =>
    isPlaceholder(part)
      ? part
      : part.replaceAll(/[aeioun]/g, (letter) => accents[letter] ?? letter),
  );
  const letters = text.replaceAll(/\{\{\w+\}\}/g, "").length;
  const more = "łonġ wörđs ænd "
    .repeat(20)
    .slice(0, Math.max(3, Math.ceil(letters * 0.4)))
    .trim();
  // A short word grows as one word, as in German; a sentence grows by words.
  return (
    accented.join("") + (letters > 12 ? " " : "") + more.replaceAll(letters > 12 ? "" : " ", "")
  );
}
