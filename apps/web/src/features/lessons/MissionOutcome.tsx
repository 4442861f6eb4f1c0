/**
 * Result of the attempt at a task: met, or what failed, where, and what to try. Announces each
 * change.
 */
import type { LessonTask } from "@corridor/challenge";
import { useEffect, useMemo } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useShallow } from "zustand/react/shallow";
import type { CheckedTask } from "../../model/check/checked-task.ts";
import { mazeName } from "../../model/check/maze-name.ts";
import { openTask } from "../../model/challenge/challenge-store.ts";
import { useServices } from "../../model/use-services.ts";
import { useWaited } from "../../model/use-waited.ts";
import { useAnnouncement } from "../../model/use-announcement.ts";
import {
  failureText,
  handText,
  liveFailureText,
  metText,
  runFailureText,
  timeLimitText,
} from "../../model/lessons/failure-text.ts";
import { handAdvice } from "../../model/lessons/hand-advice.ts";
import { stationaryRobot } from "./stationary-robot.ts";
import type { MissionWords } from "../../model/lessons/mission-words.ts";
import styles from "./mission-text.module.css";

export function MissionOutcome({ task }: { task: LessonTask }) {
  const { t, i18n } = useTranslation(["missions", "words", "diagnosis"], { useSuspense: false });
  const { t: checkText } = useTranslation("check", { useSuspense: false });
  const words: MissionWords = { t: t as unknown as MissionWords["t"], i18n };
  const { challenge: store, run, timeline, speech, workspace, cards, cardDock } = useServices();
  // The run of a check contains no waiting ticks.
  const ofRun: MissionWords = { ...words, waited: (tick) => timeline.waitedUpTo(tick) };
  const result = useStore(store, (state) => state.result);
  // Subscribes: the timeline arrives after the result.
  useWaited(result.state === "met" ? result.ticks : result.state === "failed" ? result.tick : 0);
  const verdict = useStore(store, (state) => state.verdict);
  const diagnoses = useStore(store, (state) => state.diagnoses);
  const unseenDiagnosis = useStore(store, (state) => state.unseenDiagnosis);
  const failedRun = useStore(store, (state) => state.failedRun);
  const isLesson = useStore(store, (state) => state.mission === null);
  const shown = useStore(store, (state) => state.maze);
  const driven = useStore(store, (state) => state.drivenMazes.length);
  const stationary = useStore(
    run,
    useShallow((state) => stationaryRobot(task, state)),
  );
  const maze = useStore(workspace, (state) => state.maze);
  const advice = useMemo(
    () => stationary && handAdvice(task.goal, maze, stationary),
    [task, maze, stationary],
  );
  const hasBumpAbove = useStore(cardDock, (state) => state.hasBump);
  const bump = useStore(cards, (state) => state.bump);
  const isMet = result.state === "met";
  const failure = verdict === null ? null : failureOf(verdict, shown);
  const unseen = verdict !== null && failure === verdict.failure ? verdict.failedUnseen : null;
  // The task has other mazes.
  const isDrivenHere = result.state === "here" && result.driver !== "program";
  // In a drive by hand the student may continue, so nothing has failed while the result is open.
  const isOpen = failure === null && failedRun === null && result.state === "open";
  const text = isMet
    ? metText(ofRun, task, result)
    : failure !== null
      ? failureText(
          words,
          task,
          failure,
          unseen === null ? (diagnoses[failure.maze ?? -1] ?? null) : unseenDiagnosis,
          {
            unseen:
              unseen === null ? null : mazeName(checkText, task, task.mazes.length + unseen - 1),
            isLesson,
          },
        )
      : failedRun !== null
        ? isLesson && failedRun.event.kind === "late" && failedRun.cause === null
          ? timeLimitText(ofRun, task)
          : runFailureText(ofRun, failedRun)
        : isOpen && stationary !== null && advice !== null
          ? handText(words, task, stationary.reading, advice)
          : isDrivenHere
            ? task.unseen === null
              ? t("missions:lesson.driveOthers", { done: driven, all: task.mazes.length })
              : // Only a program can be checked in unseen mazes.
                t("missions:lesson.needsProgram")
            : liveFailureText(ofRun, task, result, isLesson);
  useAnnouncement(text, "mission");
  useEffect(
    () => () => {
      // Withdraws the text only when another task opens or none is open. On a phone the card also
      // unmounts with its tab.
      if (openTask(store.getState()) !== task) speech.announceState("mission", null);
    },
    [store, speech, task],
  );
  // The card of the same bump, directly above, shows the same sentence.
  const isRepeated = hasBumpAbove && failedRun !== null && bump?.diagnosis === failedRun;
  const isShown = isMet || failure !== null || !isRepeated;
  return (
    <p
      role="note"
      className={isShown ? styles["outcome"] : "visually-hidden"}
      data-state={isMet ? "met" : isOpen || isDrivenHere ? "open" : "failed"}
    >
      {text}
    </p>
  );
}

/** The failure in the displayed maze or, if that maze passes, in the first maze that fails. */
function failureOf({ mazes, failure }: CheckedTask, shown: number): CheckedTask["failure"] {
  return mazes[shown]?.failure ?? failure;
}
