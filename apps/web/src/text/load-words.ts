/**
 * Loads texts. Each namespace of each language is a separate chunk, so that users load one language
 * only. The English namespace "words" is part of the page.
 */
import type { LanguageTag } from "./languages.ts";
import type { Namespace } from "./namespaces.ts";
import type { Words } from "./en/words.ts";

type Loader = () => Promise<Words>;

/** A language's files by name: "./cards.json" contains the texts of `cards`. */
function byName(files: Readonly<Record<string, Words>>): Words {
  return Object.fromEntries(
    Object.entries(files).map(([path, words]) => [path.slice("./".length, -".json".length), words]),
  );
}

/** The compiler requires an entry for each language. */
const loaders: Record<Exclude<LanguageTag, "en">, Loader> = {
  ar: async () => byName((await import("./ar/index.ts")).files),
  de: async () => byName((await import("./de/index.ts")).files),
  es: async () => byName((await import("./es/index.ts")).files),
  fr: async () => byName((await import("./fr/index.ts")).files),
  ja: async () => byName((await import("./ja/index.ts")).files),
  pt: async () => byName((await import("./pt/index.ts")).files),
  "zh-Hans": async () => byName((await import("./zh-Hans/index.ts")).files),
};

/**
 * Loads one namespace in one language.
 * @throws if the chunk cannot be fetched, or does not exist because it is part of the page
 */
export async function loadWords(language: LanguageTag, namespace: Namespace): Promise<Words> {
  // The loaders of the other namespaces are in a separate file, which most users do not need.
  const known =
    namespace === "words" ? loaders : (await import("./part-words.ts")).partLoaders[namespace];
  const load = (known as Partial<Record<LanguageTag, Loader>>)[language];
  if (load === undefined) throw new Error(`${namespace} in ${language} has no chunk`);
  return load();
}

/** Loads a namespace when a component first requests it. */
export const wordsBackend = {
  type: "backend",
  callbackApi: false,
  init: () => undefined,
  // i18next requests only namespaces in use and the displayed language.
  read: (tag: string, namespace: string): Promise<Words> =>
    loadWords(tag as LanguageTag, namespace as Namespace),
} as const;
