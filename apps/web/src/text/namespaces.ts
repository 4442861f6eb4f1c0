/**
 * The parts that the words come in, as English has them; `t` checks its keys against these.
 * "words" is what the page itself says. A part that only some readers need is a namespace of its own,
 * loaded in whatever language the page has when it is first used: `useTranslation("missions")`.
 */
import type { en } from "./en/index.ts";

export interface Namespaces {
  words: typeof en;
}

export type Namespace = keyof Namespaces;
