/**
 * Fetches words: each language is a chunk of its own for each namespace, so that nobody loads a
 * language that they do not read. English "words" are part of the page.
 */
import { languages, type LanguageTag } from "./languages.ts";
import type { Namespace } from "./namespaces.ts";
import type { Words } from "./words.ts";

type Loader = () => Promise<Words>;

const englishMissions: Loader = async () => (await import("./en/missions.json")).default;

/** A language's files under their names: "./cards.json" has the words of `cards`. */
function byName(files: Readonly<Record<string, Words>>): Words {
  return Object.fromEntries(
    Object.entries(files).map(([path, words]) => [path.slice("./".length, -".json".length), words]),
  );
}

/** The compiler asks for a line here for each language and each namespace. */
const loaders: {
  words: Record<Exclude<LanguageTag, "en">, Loader>;
} & Record<Exclude<Namespace, "words">, Record<LanguageTag, Loader>> = {
  words: {
    ar: async () => byName((await import("./ar/index.ts")).files),
    de: async () => byName((await import("./de/index.ts")).files),
    es: async () => byName((await import("./es/index.ts")).files),
    fr: async () => byName((await import("./fr/index.ts")).files),
    ja: async () => byName((await import("./ja/index.ts")).files),
    pt: async () => byName((await import("./pt/index.ts")).files),
    "zh-Hans": async () => byName((await import("./zh-Hans/index.ts")).files),
  },
  missions: {
    en: englishMissions,
    ar: async () => (await import("./ar/missions.json")).default,
    de: async () => (await import("./de/missions.json")).default,
    es: async () => (await import("./es/missions.json")).default,
    fr: async () => (await import("./fr/missions.json")).default,
    ja: async () => (await import("./ja/missions.json")).default,
    pt: async () => (await import("./pt/missions.json")).default,
    "zh-Hans": async () => (await import("./zh-Hans/missions.json")).default,
  },
};

/**
 * One namespace in one language.
 * @throws when the chunk cannot be fetched, or when it is part of the page already
 */
export async function loadWords(language: LanguageTag, namespace: Namespace): Promise<Words> {
  const load = (loaders[namespace] as Partial<Record<LanguageTag, Loader>>)[language];
  if (load === undefined) throw new Error(`${namespace} in ${language} has no chunk`);
  return load();
}

/** Lets i18next fetch a namespace when a component first asks for it. */
export const wordsBackend = {
  type: "backend",
  callbackApi: false,
  init: () => undefined,
  read: async (tag: string, namespace: string): Promise<Words> => {
    const language = languages.find((each) => each.tag === tag);
    if (language === undefined || !(namespace in loaders)) {
      throw new Error(`no words for ${namespace} in ${tag}`);
    }
    return loadWords(language.tag, namespace as Namespace);
  },
} as const;
