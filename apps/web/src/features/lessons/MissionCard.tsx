/** The open task in the panel: its lesson, its text, hints one by one, the check and the next step. */
import { ArrowRight, ChevronDown, ChevronUp, House, ListChecks, ListRestart, Square } from "lucide";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import {
  isJudgedByRun,
  mazeCount,
  nextMazeToDrive,
  openTask,
  showsHelp,
} from "../../model/challenge/challenge-store.ts";
import { allOf } from "../../text/all-of.ts";
import { groupedNumber } from "../../text/grouped-number.ts";
import { classNames } from "../../ui/class-names.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button, IconButton } from "../../ui/Button.tsx";
import { lazyPart } from "../../ui/lazy-part.tsx";
import type { LessonsService } from "../../model/lessons/lessons-service.ts";
import { nextTaskOf } from "../../model/lessons/task-order.ts";
import { CheckResult, RunningCheck } from "./CheckResult.tsx";
import { LessonHead, TaskRow } from "./LessonHead.tsx";
import { HintButton, HintList } from "./MissionHints.tsx";
import { MissionMazes } from "./MissionMazes.tsx";
import { MissionOutcome } from "./MissionOutcome.tsx";
import { BonusOutcome } from "./BonusOutcome.tsx";
import { TeacherHint } from "./TeacherHint.tsx";
import { TeacherText } from "./TeacherText.tsx";
import styles from "./mission-card.module.css";
import shared from "./mission-text.module.css";
import { missionIds, nextMission } from "../../model/lessons/missions/mission.ts";
import { bonusMissionIds, bonusMissionOf } from "../../model/lessons/missions/bonus-missions.ts";
import { useTask } from "./use-task.ts";

const CompletionCode = lazyPart(async () => (await import("./CompletionCode.tsx")).CompletionCode);

export interface MissionCardProps {
  /**
   * `slim` shows only the task, the newest hint of the teacher and the next step, where the drive
   * keys need the space; `hint` only the hint
   */
  look?: "full" | "slim" | "hint";
}

/** Renders nothing while no lesson is open. */
export function MissionCard({ look = "full" }: MissionCardProps) {
  const { lessons, challenge } = useServices();
  const isOpen = useStore(challenge, (state) => state.lesson !== null);
  // Another task starts without open hints.
  const task = useStore(challenge, ({ mission, index }) => mission ?? index);
  const [service, setService] = useState<LessonsService | null>(null);
  useEffect(() => {
    // Opening a lesson has already loaded the lessons. This call only returns them.
    if (isOpen) void lessons.load().then(setService, () => undefined);
  }, [isOpen, lessons]);
  if (!isOpen || service === null) return null;
  if (look === "hint") return <TeacherHint />;
  return look === "full" ? (
    <OpenMission key={task} service={service} />
  ) : (
    <SlimMission service={service} />
  );
}

function OpenMission({ service }: { service: LessonsService }) {
  const { t } = useTranslation(["missions", "words"], { useSuspense: false });
  const { challenge: store, classes, screen, cardDock } = useServices();
  // Directly above, so that the lines stay in sight.
  const isTaskAbove = useStore(cardDock, (state) => state.hasTask);
  const lesson = useStore(store, (state) => state.lesson);
  const index = useStore(store, (state) => state.index);
  const open = useStore(store, openTask);
  const isEmbedded = useStore(screen, (state) => state.isEmbedded === true);
  const mission = useStore(store, (state) => state.mission);
  const hasHints = useStore(store, ({ rights }) => showsHelp(rights, "hints"));
  const fromTeacher = useStore(store, (state) => state.hints?.[state.index] ?? 0);
  const task = useTask();
  const [hintsOpened, setHintsOpened] = useState(0);
  const hintsShown = Math.max(hintsOpened, fromTeacher);
  /** hints of the teacher when the student folded the card: a later one unfolds it */
  const [foldedAt, setFoldedAt] = useState<number | null>(null);
  const isFolded = foldedAt !== null && foldedAt >= fromTeacher;
  if (lesson === null || open === null) return null;
  const at = missionIds.findIndex((each) => each === mission);
  const id = missionIds[at];
  const bonus = bonusMissionOf(mission);
  const isMission = bonus !== null || id !== undefined;
  const hasTasks = lesson.tasks.length > 1;
  const hints =
    !hasHints && fromTeacher === 0
      ? []
      : bonus !== null
        ? Object.values(t(`missions:bonusMissions.${bonus}.hints`, { returnObjects: true }))
        : id === undefined
          ? open.words.hints
          : Object.values(t(`missions:missions.${id}.hints`, { returnObjects: true }));
  return (
    <section
      className={styles["card"]}
      aria-label={t(hasTasks ? "missions:lesson.label" : "missions:card.label")}
    >
      <div className={styles["top"]}>
        <LessonHead lesson={lesson} service={service} />
        <HelpPlace look="full" />
      </div>
      <div className={styles["head"]}>
        <div className={styles["title"]}>
          <p className={classNames(styles["number"], hasTasks && "visually-hidden")}>
            {bonus !== null
              ? t("missions:bonus.number", {
                  number: bonusMissionIds.indexOf(bonus) + 1,
                  all: bonusMissionIds.length,
                })
              : id === undefined
                ? hasTasks
                  ? t("missions:lesson.number", { number: index + 1, all: lesson.tasks.length })
                  : t("missions:card.shared")
                : t("missions:card.number", { number: at + 1, all: missionIds.length })}
          </p>
          <h2 className={styles["name"]}>
            {bonus !== null ? (
              t(`missions:bonusMissions.${bonus}.name`)
            ) : id === undefined ? (
              <TeacherText text={open.name} language={lesson.language} />
            ) : (
              t(`missions:missions.${id}.name`)
            )}
          </h2>
        </div>
        <HintButton
          shown={hintsShown}
          count={hasHints ? hints.length : 0}
          onShow={() => {
            setHintsOpened(hintsShown + 1);
            classes.getState().onHint?.(hintsShown + 1);
            setFoldedAt(null);
          }}
        />
        <IconButton label={t("missions:card.again")} onClick={() => service.attempt.restart()}>
          <Icon of={ListRestart} />
        </IconButton>
        {!isEmbedded && (
          <IconButton label={t("missions:card.own")} onClick={() => service.navigation.goHome()}>
            <Icon of={House} />
          </IconButton>
        )}
        <FoldButton
          isFolded={isFolded}
          onPress={() => setFoldedAt(isFolded ? null : fromTeacher)}
        />
      </div>
      {!isFolded && !isTaskAbove && (
        <TeacherText
          as="p"
          className={shared["task"]}
          text={task}
          language={isMission ? null : lesson.language}
        />
      )}
      {!isFolded && <UnseenNote />}
      {bonus === null ? (
        <MissionOutcome task={open} />
      ) : (
        <BonusOutcome id={bonus} service={service} />
      )}
      <CheckResult task={open} service={service} />
      {mission === null && <CompletionCodePlace />}
      <HintList
        hints={isFolded ? [] : hints.slice(0, hintsShown)}
        language={isMission ? null : lesson.language}
      />
      <div className={styles["row"]}>
        {open.mazes.length > 1 && <MissionMazes service={service} />}
        <Actions service={service} />
      </div>
    </section>
  );
}

function SlimMission({ service }: { service: LessonsService }) {
  const { t } = useTranslation(["missions", "words"], { useSuspense: false });
  const { challenge: store, cardDock } = useServices();
  const isTaskAbove = useStore(cardDock, (state) => state.hasTask);
  const lesson = useStore(store, (state) => state.lesson);
  const open = useStore(store, openTask);
  const mission = useStore(store, (state) => state.mission);
  const task = useTask();
  const [isFolded, setFolded] = useState(true);
  if (lesson === null || open === null) return null;
  const bonus = bonusMissionOf(mission);
  const hasTasks = lesson.tasks.length > 1;
  return (
    <section
      className={styles["slimCard"]}
      aria-label={t(hasTasks ? "missions:lesson.label" : "missions:card.label")}
    >
      {hasTasks && <TaskRow lesson={lesson} service={service} />}
      <div className={styles["slim"]}>
        <div className={shared["slimText"]} data-folded={isFolded}>
          {!isTaskAbove && (
            <TeacherText
              as="p"
              className={shared["slimTask"]}
              text={task}
              language={mission === null ? lesson.language : null}
            />
          )}
          {bonus === null ? (
            <MissionOutcome task={open} />
          ) : (
            <BonusOutcome id={bonus} service={service} />
          )}
        </div>
        {!isTaskAbove && (
          <span className={shared["fold"]}>
            <FoldButton isFolded={isFolded} onPress={() => setFolded(!isFolded)} />
          </span>
        )}
        <RunningCheck service={service} />
        <NextStep service={service} />
        <HelpPlace look="slim" />
      </div>
      <TeacherHint />
    </section>
  );
}

function FoldButton({ isFolded, onPress }: { isFolded: boolean; onPress: () => void }) {
  const { t } = useTranslation("missions", { useSuspense: false });
  return (
    <IconButton label={t(isFolded ? "card.unfold" : "card.fold")} onClick={onPress}>
      <Icon of={isFolded ? ChevronDown : ChevronUp} />
    </IconButton>
  );
}

/** The request for help of a student in a class. */
function HelpPlace({ look }: { look: "full" | "slim" }) {
  const { classes } = useServices();
  return useStore(classes, (state) => state.help)?.(look);
}

/**
 * The code of a solved task of a lesson. Corridor's own missions need none, and the teacher of a
 * class has it already.
 */
function CompletionCodePlace() {
  const { challenge: store } = useServices();
  // Only the lesson of a class has hints from the teacher, or none yet.
  const isOfClass = useStore(store, ({ hints }) => hints !== undefined);
  const lesson = useStore(store, (state) => state.lesson);
  const index = useStore(store, (state) => state.index);
  const driver = useStore(store, ({ result }) => (result.state === "met" ? result.driver : null));
  if (isOfClass || lesson === null || driver === null) return null;
  return <CompletionCode lesson={lesson} task={index} driver={driver} />;
}

/** The unseen mazes of the task, so that no one takes the given ones for all. */
function UnseenNote() {
  const { t, i18n } = useTranslation("missions", { useSuspense: false });
  const { challenge: store } = useServices();
  const unseen = useStore(store, (state) => openTask(state)?.unseen ?? null);
  if (unseen === null) return null;
  const all = groupedNumber(unseen.count, i18n.language);
  const pass = groupedNumber(unseen.pass, i18n.language);
  return <p className={styles["unseen"]}>{t("lesson.unseen", { all, pass })}</p>;
}

/**
 * The check where the task has one, and the next step once the task is met. Until then the row of
 * tasks or the Lessons dialog offers every task.
 */
function Actions({ service }: { service: LessonsService }) {
  const { t, i18n } = useTranslation(["missions", "words", "check"], { useSuspense: false });
  const { challenge: store } = useServices();
  const task = useStore(store, openTask);
  const mission = useStore(store, (state) => state.mission);
  const result = useStore(store, (state) => state.result);
  const isChecking = useStore(store, (state) => state.isChecking);
  const hasCard = useStore(store, (state) => state.hasCard);
  if (task === null) return null;
  const isMet = result.state === "met";
  const isChecked =
    bonusMissionOf(mission) === null &&
    !isJudgedByRun(task) &&
    task.allowed.drivers.includes("program");
  return (
    <div className={styles["actions"]}>
      {isChecked && !isMet && (
        // One button for both, so that the focus stays on it. The card has the same primary button.
        <Button
          size="small"
          kind={isChecking || hasCard ? "outline" : "primary"}
          icon={<Icon of={isChecking ? Square : ListChecks} />}
          onClick={() => {
            if (isChecking) service.check.stop();
            else void service.attempt.check();
          }}
        >
          {isChecking
            ? t("check:progress.stop")
            : t("missions:card.check", allOf(mazeCount(task), i18n.language))}
        </Button>
      )}
      <NextStep service={service} />
      {isMet && mission !== null && nextMission(mission) === null && (
        <Button size="small" kind="primary" onClick={() => store.setState({ isPathOpen: true })}>
          {t("missions:card.last")}
        </Button>
      )}
    </div>
  );
}

/** The button to the next maze, task or mission. The card beside the robot has the same button. */
function NextStep({ service }: { service: LessonsService }) {
  const { t } = useTranslation("missions", { useSuspense: false });
  const { challenge: store, lessons } = useServices();
  const hasCard = useStore(store, (state) => state.hasCard);
  const isMet = useStore(store, ({ result }) => result.state === "met");
  const maze = useStore(store, nextMazeToDrive);
  const mission = useStore(store, (state) => nextMission(state.mission));
  const task = useStore(store, nextTaskOf);
  const isAllSolved = useStore(store, ({ solved }) => solved.length > 0 && !solved.includes(false));
  if (hasCard || (!isMet && maze === null)) return null;
  if (isMet && isAllSolved) return <p className={styles["allSolved"]}>{t("lesson.allSolved")}</p>;
  if (maze === null && mission === null && task === null) return null;
  return (
    <Button
      size="small"
      kind="primary"
      onClick={() => {
        if (maze !== null) service.navigation.showMaze(maze);
        else if (mission !== null) void lessons.openMission(mission);
        else if (task !== null) service.navigation.openTask(task);
      }}
    >
      {maze === null
        ? t(mission === null ? "lesson.next" : "card.next")
        : t("card.maze", { number: maze + 1 })}
      <Icon of={ArrowRight} className={styles["onward"]} />
    </Button>
  );
}
