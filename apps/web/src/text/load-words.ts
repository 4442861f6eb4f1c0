/**
 * Fetches words: each language is a chunk of its own for each namespace, so that nobody loads a
 * language that they do not read. English "words" are part of the page.
 */
import type { LanguageTag } from "./languages.ts";
import type { Namespace } from "./namespaces.ts";
import type { Words } from "./en/words.ts";

type Loader = () => Promise<Words>;

/** A language's files under their names: "./cards.json" has the words of `cards`. */
function byName(files: Readonly<Record<string, Words>>): Words {
  return Object.fromEntries(
    Object.entries(files).map(([path, words]) => [path.slice("./".length, -".json".length), words]),
  );
}

/** The compiler asks for a line here for each language. */
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
 * One namespace in one language.
 * @throws when the chunk cannot be fetched, or when it is part of the page already
 */
export async function loadWords(language: LanguageTag, namespace: Namespace): Promise<Words> {
  // Where the parts are is known by a file of its own: most readers need none of them.
  const known =
    namespace === "words" ? loaders : (await import("./part-words.ts")).partLoaders[namespace];
  const load = (known as Partial<Record<LanguageTag, Loader>>)[language];
  if (load === undefined) throw new Error(`${namespace} in ${language} has no chunk`);
  return load();
}

/** Lets i18next fetch a namespace when a component first asks for it. */
export const wordsBackend = {
  type: "backend",
  callbackApi: false,
  init: () => undefined,
  // It asks for what the page speaks and uses alone; anything else has no chunk.
  read: (tag: string, namespace: string): Promise<Words> =>
    loadWords(tag as LanguageTag, namespace as Namespace),
} as const;
