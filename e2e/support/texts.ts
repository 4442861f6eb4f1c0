// cspell:words Cøpy lïñk łonġ wörđs
/**
 * The texts of the page in one language, read from its catalogues, and a pseudolocale: English with
 * accents and 40 % more letters, which finds texts that do not fit before a translator does.
 */
import { readdirSync, readFileSync } from "node:fs";

interface Catalogue {
  [key: string]: string | Catalogue;
}

const folder = new URL("../../apps/web/src/text/", import.meta.url);

export class Texts {
  readonly #catalogue: Catalogue;

  /** characters around a value: right-to-left pages isolate values */
  readonly #isolate: readonly [string, string];

  private constructor(catalogue: Catalogue, isRightToLeft: boolean) {
    this.#catalogue = catalogue;
    this.#isolate = isRightToLeft ? ["\u2068", "\u2069"] : ["", ""];
  }

  /** The texts of a language. Like the page, it falls back to English for missing texts. */
  static load(tag: string): Texts {
    const isRightToLeft = new Intl.Locale(tag).maximize().script === "Arab";
    return new Texts(merged(readCatalogue("en"), readCatalogue(tag)), isRightToLeft);
  }

  static pseudolocale(): Texts {
    return new Texts(mapped(readCatalogue("en"), pseudolocalize), false);
  }

  /** The text at a path such as "shell.run.run", with its placeholders filled. */
  t(path: string, values: Readonly<Record<string, string | number>> = {}): string {
    let at: string | Catalogue | undefined = this.#catalogue;
    for (const key of path.split(".")) at = typeof at === "object" ? at[key] : undefined;
    if (typeof at !== "string") throw new Error(`no text ${path}`);
    const [open, close] = this.#isolate;
    return at.replaceAll(
      /\{\{(\w+)\}\}/g,
      (_, name: string) => `${open}${values[name] ?? ""}${close}`,
    );
  }

  /** The source of a module that exports all texts by file name, as a language's chunk does. */
  asModule(): string {
    const files = Object.entries(this.#catalogue).map(([name, texts]) => [`./${name}.json`, texts]);
    return `export const files = ${JSON.stringify(Object.fromEntries(files))};`;
  }
}

/** Tags of the languages that have a folder of texts. */
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
function pseudolocalize(text: string): string {
  const [first = "", ...rest] = text.split(/(?=\{\{)|(?<=\}\})/);
  const isPlaceholder = (part: string): boolean => part.startsWith("{{");
  const accented = [first, ...rest].map((part) =>
    isPlaceholder(part)
      ? part
      : part.replaceAll(/[aeioun]/g, (letter) => accents[letter] ?? letter),
  );
  const letters = text.replaceAll(/\{\{\w+\}\}/g, "").length;
  const padding = "łonġ wörđs ænd "
    .repeat(20)
    .slice(0, Math.max(3, Math.ceil(letters * 0.4)))
    .trim();
  // A short text grows as one word, as in German. A sentence grows by words.
  return (
    accented.join("") + (letters > 12 ? " " : "") + padding.replaceAll(letters > 12 ? "" : " ", "")
  );
}
