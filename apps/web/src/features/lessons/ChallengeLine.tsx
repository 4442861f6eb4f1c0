/**
 * The open task above the maze. Once it is met, the line turns green and shows the
 * result.
 */
import { Check, Target } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { useWaited } from "../../model/use-waited.ts";
import { challengeResult, mazeCount, openTask } from "../../model/challenge/challenge-store.ts";
import { allOf } from "../../text/all-of.ts";
import { metText } from "../../model/lessons/failure-text.ts";
import { Icon } from "../../ui/Icon.tsx";
import { TeacherText } from "./TeacherText.tsx";
import styles from "./challenge-line.module.css";
import { missionIds } from "../../model/lessons/missions/mission.ts";
import { bonusMissionOf } from "../../model/lessons/missions/bonus-missions.ts";

export function ChallengeLine() {
  const { t, i18n } = useTranslation(["missions", "words"], { useSuspense: false });
  const { challenge: store } = useServices();
  const task = useStore(store, openTask);
  const language = useStore(store, (state) => state.lesson?.language ?? null);
  const mission = useStore(store, (state) => state.mission);
  const result = useStore(store, challengeResult);
  const isChecked = useStore(store, (state) => state.checked !== null);
  const waited = useWaited(result?.state === "met" ? result.ticks : 0);
  if (task === null || result === null) return null;
  const id = missionIds.find((each) => each === mission);
  const bonus = bonusMissionOf(mission);
  if (result.state === "met") {
    return (
      <p className={styles["line"]} data-state="met" dir="auto">
        <Icon of={Check} size={18} />
        {metText({ t, i18n, waited: () => waited }, task, result)}
      </p>
    );
  }
  const count = mazeCount(task);
  const isHere = result.state === "here" && count > 1;
  if (isHere) {
    return (
      <p className={styles["line"]} dir="auto">
        <Icon of={Target} size={18} />
        <span className={styles["short"]}>
          {isChecked || result.driver !== "program"
            ? t("missions:bar.hereOnly")
            : t("missions:bar.here", allOf(count, i18n.language))}
        </span>
      </p>
    );
  }
  return (
    <p className={styles["line"]} dir="auto">
      <Icon of={Target} size={18} />
      {bonus === null && id === undefined ? (
        <TeacherText
          className={styles["short"]}
          language={language}
          text={task.words.short || task.words.task || task.name}
        />
      ) : (
        <span className={styles["short"]}>
          {bonus === null
            ? t(`missions:missions.${id ?? "make-it-move"}.short`)
            : t(`missions:bonusMissions.${bonus}.short`)}
        </span>
      )}
    </p>
  );
}
