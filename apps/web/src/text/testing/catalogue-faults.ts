/** Checks a translated catalogue against the English one. */

/** The contents of a language's JSON files. */
export interface Catalogue {
  readonly [key: string]: string | Catalogue;
}

/** Names and units that are the same in every language. */
const names = new Set(
  `Corridor Python JavaScript Java curl HTTP QR PNG SVG JSON URL
   Ctrl Alt Shift Tab Enter Space Esc Delete Home End Page Up Down W A S D C X
   cm MB`.split(/\s+/),
);

const plural = /^(?<base>.+)_(?<form>zero|one|two|few|many|other)$/;

/**
 * @param tag BCP 47 tag, for plural forms and script
 * @param mayLack permits missing texts, for a draft
 * @returns one message per fault, starting with the key
 */
export function catalogueFaults(
  english: Catalogue,
  translated: Catalogue,
  tag: string,
  { mayLack = false } = {},
): string[] {
  const source = flat(english);
  const target = flat(translated);
  const expected = expectedKeys([...source.keys()], tag);
  const faults: string[] = [];
  for (const [key, models] of expected) {
    const text = target.get(key);
    if (text === undefined) {
      if (!mayLack) faults.push(`${key}: is missing`);
      continue;
    }
    const english = models.map((model) => source.get(model) ?? "");
    for (const fault of textFaults(english, text, tag)) faults.push(`${key}: ${fault}`);
  }
  for (const key of target.keys()) {
    if (!expected.has(key)) faults.push(`${key}: is not in English`);
  }
  return faults;
}

/** Checks the English catalogue itself. */
export function sourceFaults(english: Catalogue): string[] {
  return [...flat(english)].flatMap(([key, text]) =>
    shapeFaults(text).map((fault) => `${key}: ${fault}`),
  );
}

/** Every text by its path, "stage.cell.at". */
function flat(catalogue: Catalogue, path = ""): Map<string, string> {
  const texts = new Map<string, string>();
  for (const [key, value] of Object.entries(catalogue)) {
    if (typeof value === "string") texts.set(path + key, value);
    else for (const [inner, text] of flat(value, `${path}${key}.`)) texts.set(inner, text);
  }
  return texts;
}

/** The keys that a language needs, each with the corresponding English keys. */
function expectedKeys(keys: readonly string[], tag: string): Map<string, string[]> {
  const expected = new Map<string, string[]>();
  const forms = new Intl.PluralRules(tag).resolvedOptions().pluralCategories;
  for (const key of keys) {
    const { base, form } = plural.exec(key)?.groups ?? {};
    if (base === undefined) {
      expected.set(key, [key]);
      continue;
    }
    const models = keys.filter((other) => plural.exec(other)?.groups?.["base"] === base);
    // English may add the form "zero", which i18next uses for 0 in any language.
    for (const each of form === "zero" ? [form] : forms) expected.set(`${base}_${each}`, models);
  }
  return expected;
}

function textFaults(english: readonly string[], text: string, tag: string): string[] {
  const faults = shapeFaults(text);
  const wanted = english.map(placeholders);
  const known = new Set(wanted.flatMap((each) => [...each]));
  const has = placeholders(text);
  for (const name of has) if (!known.has(name)) faults.push(`{{${name}}} is not in English`);
  for (const name of known) {
    // A form for 0 or 1 may omit the number or write it in words.
    const isFree = name === "count" && english.length > 1;
    if (!has.has(name) && !isFree && wanted.every((each) => each.has(name))) {
      faults.push(`{{${name}}} is missing`);
    }
  }
  if (isLeftEnglish(english, text, tag)) faults.push(`is still English: ${text}`);
  if (english.every((each) => each.endsWith(".")) && !/[.。؟!！]\p{Pf}?$/u.test(text)) {
    faults.push("does not end as a sentence");
  }
  return faults;
}

function shapeFaults(text: string): string[] {
  const faults: string[] = [];
  if (text.trim() === "") faults.push("is empty");
  if (text !== text.trim() || / {2}/.test(text)) faults.push("has invisible spaces");
  if (/<[a-z/!]|&[a-z]+;|&#/i.test(text)) faults.push("contains HTML");
  if (text.replaceAll(/\{\{\w+\}\}/g, "").match(/[{}]/) !== null) {
    faults.push("has a broken placeholder");
  }
  return faults;
}

function placeholders(text: string): Set<string> {
  return new Set([...text.matchAll(/\{\{(\w+)\}\}/g)].map(([, name = ""]) => name));
}

/** Whether a text equals the English one or, in another script, has no letter of that script. */
function isLeftEnglish(english: readonly string[], text: string, tag: string): boolean {
  const words = (text.replaceAll(/\{\{\w+\}\}/g, "").match(/\p{L}+/gu) ?? []).filter(
    (word) => !names.has(word),
  );
  const { script } = new Intl.Locale(tag).maximize();
  if (script === "Latn") return words.length > 1 && english.includes(text);
  return words.length > 0 && words.every((word) => /^\p{Script=Latin}+$/u.test(word));
}
