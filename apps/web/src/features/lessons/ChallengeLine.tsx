/**
 * The task of the open challenge above the maze. Once it is met, the line turns green and shows the
 * result.
 */
import { Check, Target } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { challengeResult } from "../../model/challenge/challenge-store.ts";
import { allOf } from "../../text/all-of.ts";
import { metText } from "../../model/lessons/failure-text.ts";
import { Icon } from "../../ui/Icon.tsx";
import styles from "./challenge-line.module.css";
import { missionIds } from "../../model/lessons/missions/mission.ts";
import { bonusMissionOf } from "../../model/lessons/missions/bonus-missions.ts";

export function ChallengeLine() {
  const { t, i18n } = useTranslation(["missions", "words"], { useSuspense: false });
  const { challenge: store, timeline } = useServices();
  const challenge = useStore(store, (state) => state.challenge);
  const mission = useStore(store, (state) => state.mission);
  const result = useStore(store, challengeResult);
  const isChecked = useStore(store, (state) => state.checked !== null);
  if (challenge === null || result === null) return null;
  const id = missionIds.find((each) => each === mission);
  const bonus = bonusMissionOf(mission);
  if (result.state === "met") {
    return (
      <p className={styles["line"]} data-state="met" dir="auto">
        <Icon of={Check} size={18} />
        {metText({ t, i18n, waited: (tick) => timeline.waitedUpTo(tick) }, challenge, result)}
      </p>
    );
  }
  const isHere = result.state === "here" && challenge.mazes.length > 1;
  return (
    <p className={styles["line"]} dir="auto">
      <Icon of={Target} size={18} />
      <span className={styles["short"]}>
        {isHere
          ? isChecked
            ? t("missions:bar.hereOnly")
            : t("missions:bar.here", allOf(challenge.mazes.length))
          : bonus !== null
            ? t(`missions:bonusMissions.${bonus}.short`)
            : id === undefined
              ? challenge.words.short
              : t(`missions:missions.${id}.short`)}
      </span>
    </p>
  );
}
