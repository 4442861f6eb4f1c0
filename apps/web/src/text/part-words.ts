/** Where the parts of the words are that only some readers need: a chunk for each language and each part. */
import type { LanguageTag } from "./languages.ts";
import type { Namespace } from "./namespaces.ts";
import type { Words } from "./words.ts";

/** The compiler asks for a line here for each language and each part. */
export const partLoaders: Record<
  Exclude<Namespace, "words">,
  Record<LanguageTag, () => Promise<Words>>
> = {
  missions: {
    en: async () => (await import("./en/missions.json")).default,
    ar: async () => (await import("./ar/missions.json")).default,
    de: async () => (await import("./de/missions.json")).default,
    es: async () => (await import("./es/missions.json")).default,
    fr: async () => (await import("./fr/missions.json")).default,
    ja: async () => (await import("./ja/missions.json")).default,
    pt: async () => (await import("./pt/missions.json")).default,
    "zh-Hans": async () => (await import("./zh-Hans/missions.json")).default,
  },
  watch: {
    en: async () => (await import("./en/watch.json")).default,
    ar: async () => (await import("./ar/watch.json")).default,
    de: async () => (await import("./de/watch.json")).default,
    es: async () => (await import("./es/watch.json")).default,
    fr: async () => (await import("./fr/watch.json")).default,
    ja: async () => (await import("./ja/watch.json")).default,
    pt: async () => (await import("./pt/watch.json")).default,
    "zh-Hans": async () => (await import("./zh-Hans/watch.json")).default,
  },
};
