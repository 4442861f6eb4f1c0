/** Loaders of the namespaces that only some users need: one chunk per language and namespace. */
import type { LanguageTag } from "./languages.ts";
import type { Namespace } from "./namespaces.ts";
import type { Words } from "./en/words.ts";

/** The compiler requires an entry for each namespace and language. */
export const partLoaders: Record<
  Exclude<Namespace, "words">,
  Record<LanguageTag, () => Promise<Words>>
> = {
  diagnosis: {
    en: async () => (await import("./en/diagnosis.json")).default,
    ar: async () => (await import("./ar/diagnosis.json")).default,
    de: async () => (await import("./de/diagnosis.json")).default,
    es: async () => (await import("./es/diagnosis.json")).default,
    fr: async () => (await import("./fr/diagnosis.json")).default,
    ja: async () => (await import("./ja/diagnosis.json")).default,
    pt: async () => (await import("./pt/diagnosis.json")).default,
    "zh-Hans": async () => (await import("./zh-Hans/diagnosis.json")).default,
  },
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
  otherMazes: {
    en: async () => (await import("./en/other-mazes.json")).default,
    ar: async () => (await import("./ar/other-mazes.json")).default,
    de: async () => (await import("./de/other-mazes.json")).default,
    es: async () => (await import("./es/other-mazes.json")).default,
    fr: async () => (await import("./fr/other-mazes.json")).default,
    ja: async () => (await import("./ja/other-mazes.json")).default,
    pt: async () => (await import("./pt/other-mazes.json")).default,
    "zh-Hans": async () => (await import("./zh-Hans/other-mazes.json")).default,
  },
  runDetails: {
    en: async () => (await import("./en/run-details.json")).default,
    ar: async () => (await import("./ar/run-details.json")).default,
    de: async () => (await import("./de/run-details.json")).default,
    es: async () => (await import("./es/run-details.json")).default,
    fr: async () => (await import("./fr/run-details.json")).default,
    ja: async () => (await import("./ja/run-details.json")).default,
    pt: async () => (await import("./pt/run-details.json")).default,
    "zh-Hans": async () => (await import("./zh-Hans/run-details.json")).default,
  },
  race: {
    en: async () => (await import("./en/race.json")).default,
    ar: async () => (await import("./ar/race.json")).default,
    de: async () => (await import("./de/race.json")).default,
    es: async () => (await import("./es/race.json")).default,
    fr: async () => (await import("./fr/race.json")).default,
    ja: async () => (await import("./ja/race.json")).default,
    pt: async () => (await import("./pt/race.json")).default,
    "zh-Hans": async () => (await import("./zh-Hans/race.json")).default,
  },
  daily: {
    en: async () => (await import("./en/daily.json")).default,
    ar: async () => (await import("./ar/daily.json")).default,
    de: async () => (await import("./de/daily.json")).default,
    es: async () => (await import("./es/daily.json")).default,
    fr: async () => (await import("./fr/daily.json")).default,
    ja: async () => (await import("./ja/daily.json")).default,
    pt: async () => (await import("./pt/daily.json")).default,
    "zh-Hans": async () => (await import("./zh-Hans/daily.json")).default,
  },
  sound: {
    en: async () => (await import("./en/sound.json")).default,
    ar: async () => (await import("./ar/sound.json")).default,
    de: async () => (await import("./de/sound.json")).default,
    es: async () => (await import("./es/sound.json")).default,
    fr: async () => (await import("./fr/sound.json")).default,
    ja: async () => (await import("./ja/sound.json")).default,
    pt: async () => (await import("./pt/sound.json")).default,
    "zh-Hans": async () => (await import("./zh-Hans/sound.json")).default,
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
