/** State of the open bonus mission, and the best result on this device. Announces changes. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useAnnouncement } from "../../model/use-announcement.ts";
import type { LessonsService } from "../../model/lessons/lessons-service.ts";
import styles from "./bonus-outcome.module.css";
import shared from "./mission-text.module.css";
import type { BonusMissionId } from "../../model/lessons/missions/bonus-missions.ts";
import { bestText, isReached, statusText } from "./bonus-text.ts";

interface BonusOutcomeProps {
  id: BonusMissionId;
  service: LessonsService;
}

export function BonusOutcome({ id, service }: BonusOutcomeProps) {
  const words = useTranslation(["missions", "words"], { useSuspense: false });
  const status = useStore(service.bonus.status, (state) => state.status);
  const best = useStore(service.progress.results, (state) => state.best[id]);
  const text = statusText(words, status);
  useAnnouncement(status.kind === "checking" ? null : text, "mission");
  return (
    <>
      <p role="note" className={shared["outcome"]} data-state={isReached(status) ? "met" : "open"}>
        {text}
      </p>
      {best !== undefined && <p className={styles["best"]}>{bestText(words, id, best)}</p>}
    </>
  );
}
