/**
 * The translator and its language, as `useTranslation` returns them, for the texts of the missions.
 */
import type { TFunction } from "i18next";

export interface MissionWords {
  t: TFunction<["missions", "words"]>;
  i18n: { language: string };
  /**
   * waiting ticks up to a tick of the displayed run, in which a script made the robot wait; the
   * clock excludes them
   */
  waited?: (tick: number) => number;
}
