/**
 * The parts that the words come in, as English has them; `t` checks its keys against these.
 * "words" is what the page itself says. A part that only some readers need is a namespace of its own,
 * loaded in whatever language the page has when it is first used: `useTranslation("missions")`.
 */
import type { en } from "./en/index.ts";
import type missions from "./en/missions.json";
import type watch from "./en/watch.json";

export interface Namespaces {
  words: typeof en;
  /** the lessons */
  missions: typeof missions;
  /** the page of whoever looks on */
  watch: typeof watch;
}

export type Namespace = keyof Namespaces;
