import type { ChallengeDocument } from "@corridor/challenge";
import type { i18n } from "i18next";
import { challengeOf, type Mission } from "./missions/mission.ts";
import { bonusMissionOf, type BonusMission } from "./missions/bonus-missions.ts";

/**
 * A mission as a complete document, in the language of the page.
 * @param words with the namespace "missions" loaded
 */
export function missionDocument(
  mission: Mission | BonusMission,
  { t }: Pick<i18n, "t">,
): ChallengeDocument {
  const bonus = bonusMissionOf(mission.id);
  const key =
    bonus === null
      ? (`missions:missions.${mission.id as Mission["id"]}` as const)
      : (`missions:bonusMissions.${bonus}` as const);
  return challengeOf(mission, t(`${key}.name`), {
    task: t(`${key}.task`),
    short: t(`${key}.short`),
    hints: Object.values(t(`${key}.hints`, { returnObjects: true })),
  });
}
