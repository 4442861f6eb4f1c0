/** The open mission in the panel: its task, hints one by one, the check and the next step. */
import { ArrowRight, ChevronDown, ChevronUp, House, ListChecks, ListRestart } from "lucide";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { isJudgedByRun } from "../../model/challenge/challenge-store.ts";
import { allOf } from "../../text/all-of.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button, IconButton } from "../../ui/Button.tsx";
import type { LessonsService } from "../../model/lessons/lessons-service.ts";
import { HintButton, HintList } from "./MissionHints.tsx";
import { MissionMazes } from "./MissionMazes.tsx";
import { MissionOutcome } from "./MissionOutcome.tsx";
import { BonusOutcome } from "./BonusOutcome.tsx";
import styles from "./mission-card.module.css";
import shared from "./mission-text.module.css";
import { missionIds, nextMission } from "../../model/lessons/missions/mission.ts";
import { bonusMissionIds, bonusMissionOf } from "../../model/lessons/missions/bonus-missions.ts";
import { useTask } from "./use-task.ts";

export interface MissionCardProps {
  /** `slim` shows only the task and the next step, where the drive keys need the space */
  look?: "full" | "slim";
}

/** Renders nothing while no challenge is open. */
export function MissionCard({ look = "full" }: MissionCardProps) {
  const { lessons, challenge } = useServices();
  const isOpen = useStore(challenge, (state) => state.challenge !== null);
  const mission = useStore(challenge, (state) => state.mission);
  const [service, setService] = useState<LessonsService | null>(null);
  useEffect(() => {
    // Opening a challenge has already loaded the lessons. This call only returns them.
    if (isOpen) void lessons.load().then(setService, () => undefined);
  }, [isOpen, lessons]);
  if (!isOpen || service === null) return null;
  return look === "full" ? (
    <OpenMission key={mission} service={service} />
  ) : (
    <SlimMission service={service} />
  );
}

function OpenMission({ service }: { service: LessonsService }) {
  const { t } = useTranslation(["missions", "words"], { useSuspense: false });
  const { challenge: store } = useServices();
  const challenge = useStore(store, (state) => state.challenge);
  const mission = useStore(store, (state) => state.mission);
  const task = useTask();
  const [hintsShown, setHintsShown] = useState(0);
  const [isFolded, setFolded] = useState(false);
  if (challenge === null) return null;
  const at = missionIds.findIndex((each) => each === mission);
  const id = missionIds[at];
  const bonus = bonusMissionOf(mission);
  const hints =
    bonus !== null
      ? Object.values(t(`missions:bonusMissions.${bonus}.hints`, { returnObjects: true }))
      : id === undefined
        ? challenge.words.hints
        : Object.values(t(`missions:missions.${id}.hints`, { returnObjects: true }));
  return (
    <section className={styles["card"]} aria-label={t("missions:card.label")}>
      <div className={styles["head"]}>
        <div className={styles["title"]}>
          <p className={styles["number"]}>
            {bonus !== null
              ? t("missions:bonus.number", {
                  number: bonusMissionIds.indexOf(bonus) + 1,
                  all: bonusMissionIds.length,
                })
              : id === undefined
                ? t("missions:card.shared")
                : t("missions:card.number", { number: at + 1, all: missionIds.length })}
          </p>
          <h2 className={styles["name"]}>
            {bonus !== null
              ? t(`missions:bonusMissions.${bonus}.name`)
              : id === undefined
                ? challenge.name
                : t(`missions:missions.${id}.name`)}
          </h2>
        </div>
        <HintButton
          shown={hintsShown}
          count={hints.length}
          onShow={() => {
            setHintsShown(hintsShown + 1);
            setFolded(false);
          }}
        />
        <IconButton label={t("missions:card.again")} onClick={() => service.attempt.restart()}>
          <Icon of={ListRestart} />
        </IconButton>
        <IconButton label={t("missions:card.own")} onClick={() => service.navigation.goHome()}>
          <Icon of={House} />
        </IconButton>
        <IconButton
          label={t(isFolded ? "missions:card.unfold" : "missions:card.fold")}
          onClick={() => setFolded(!isFolded)}
        >
          {isFolded ? <Icon of={ChevronDown} /> : <Icon of={ChevronUp} />}
        </IconButton>
      </div>
      {!isFolded && <p className={shared["task"]}>{task}</p>}
      {bonus === null ? (
        <MissionOutcome challenge={challenge} />
      ) : (
        <BonusOutcome id={bonus} service={service} />
      )}
      <HintList hints={isFolded ? [] : hints.slice(0, hintsShown)} />
      <div className={styles["row"]}>
        {challenge.mazes.length > 1 && <MissionMazes service={service} />}
        <Actions service={service} />
      </div>
    </section>
  );
}

function SlimMission({ service }: { service: LessonsService }) {
  const { t } = useTranslation(["missions", "words"], { useSuspense: false });
  const { challenge: store, lessons } = useServices();
  const challenge = useStore(store, (state) => state.challenge);
  const mission = useStore(store, (state) => state.mission);
  const isMet = useStore(store, (state) => state.result.state === "met");
  const isCardShown = useStore(store, (state) => state.hasCard);
  const task = useTask();
  if (challenge === null) return null;
  const next = nextMission(mission);
  const bonus = bonusMissionOf(mission);
  return (
    <section className={styles["slim"]} aria-label={t("missions:card.label")}>
      {!isMet && <p className={shared["slimTask"]}>{task}</p>}
      {bonus === null ? (
        <MissionOutcome challenge={challenge} />
      ) : (
        <BonusOutcome id={bonus} service={service} />
      )}
      {isMet && !isCardShown && next !== null && (
        <Button size="small" kind="primary" onClick={() => void lessons.openMission(next)}>
          {t("missions:card.next")}
          <Icon of={ArrowRight} className={styles["onward"]} />
        </Button>
      )}
    </section>
  );
}

/**
 * The check where the mission has one, and the next step once the mission is met. Until then the
 * Lessons dialog offers every mission.
 */
function Actions({ service }: { service: LessonsService }) {
  const { t } = useTranslation(["missions", "words"], { useSuspense: false });
  const { challenge: store, lessons } = useServices();
  const challenge = useStore(store, (state) => state.challenge);
  const mission = useStore(store, (state) => state.mission);
  const result = useStore(store, (state) => state.result);
  const isChecking = useStore(store, (state) => state.isChecking);
  const isCardShown = useStore(store, (state) => state.hasCard);
  if (challenge === null) return null;
  const isMet = result.state === "met";
  // The card beside the robot has the same button.
  const leadsOn = isMet && !isCardShown;
  const next = nextMission(mission);
  const isChecked =
    bonusMissionOf(mission) === null &&
    !isJudgedByRun(challenge) &&
    challenge.allowed.drivers.includes("program");
  return (
    <div className={styles["actions"]}>
      {isChecked && !isMet && (
        <Button
          size="small"
          kind="primary"
          disabled={isChecking}
          icon={<Icon of={ListChecks} />}
          onClick={() => void service.attempt.check()}
        >
          {isChecking
            ? t("missions:card.checking")
            : t("missions:card.check", allOf(challenge.mazes.length))}
        </Button>
      )}
      {leadsOn && next !== null && (
        <Button size="small" kind="primary" onClick={() => void lessons.openMission(next)}>
          {t("missions:card.next")}
          <Icon of={ArrowRight} className={styles["onward"]} />
        </Button>
      )}
      {isMet && next === null && mission !== null && (
        <Button size="small" kind="primary" onClick={() => store.setState({ isPathOpen: true })}>
          {t("missions:card.last")}
        </Button>
      )}
    </div>
  );
}
