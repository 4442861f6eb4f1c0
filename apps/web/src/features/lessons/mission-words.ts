/** What `useTranslation` gives to the sentences of the missions: the words, and the language that they are in. */
import type { TFunction } from "i18next";

export interface MissionWords {
  t: TFunction<["missions", "words"]>;
  i18n: { language: string };
  /** ticks up to one of the displayed run in which a script let the robot wait, which the clock counts apart */
  waited?: (tick: number) => number;
}
