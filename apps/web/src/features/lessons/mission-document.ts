/** A mission as a whole document, in the language of the page. */
import type { ChallengeDocument } from "@corridor/challenge";
import type { i18n } from "i18next";
import { challengeOf, type Mission } from "./missions/mission.ts";

/** @param words with the namespace "missions" loaded */
export function missionDocument(mission: Mission, { t }: Pick<i18n, "t">): ChallengeDocument {
  const key = `missions:missions.${mission.id}` as const;
  return challengeOf(mission, t(`${key}.name`), {
    task: t(`${key}.task`),
    short: t(`${key}.short`),
    hints: Object.values(t(`${key}.hints`, { returnObjects: true })),
  });
}
