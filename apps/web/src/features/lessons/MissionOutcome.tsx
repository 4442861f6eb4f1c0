/**
 * Result of the attempt at a mission: met, or what failed, where, and what to try. Announces each
 * change.
 */
import type { ChallengeDocument, Verdict } from "@corridor/challenge";
import { useEffect, useMemo } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useShallow } from "zustand/react/shallow";
import { useServices } from "../../model/use-services.ts";
import { useAnnouncement } from "../../model/use-announcement.ts";
import {
  failureText,
  handText,
  liveFailureText,
  metText,
  runFailureText,
} from "../../model/lessons/failure-text.ts";
import { handAdvice } from "../../model/lessons/hand-advice.ts";
import { stationaryRobot } from "./stationary-robot.ts";
import type { MissionWords } from "../../model/lessons/mission-words.ts";
import styles from "./mission-text.module.css";

export function MissionOutcome({ challenge }: { challenge: ChallengeDocument }) {
  const { t, i18n } = useTranslation(["missions", "words", "diagnosis"], { useSuspense: false });
  const words: MissionWords = { t: t as unknown as MissionWords["t"], i18n };
  const { challenge: store, run, timeline, speech, workspace, cards, cardDock } = useServices();
  // The run of a check contains no waiting ticks.
  const ofRun: MissionWords = { ...words, waited: (tick) => timeline.waitedUpTo(tick) };
  const result = useStore(store, (state) => state.result);
  const verdict = useStore(store, (state) => state.verdict);
  const diagnoses = useStore(store, (state) => state.diagnoses);
  const failedRun = useStore(store, (state) => state.failedRun);
  const shown = useStore(store, (state) => state.maze);
  const stationary = useStore(
    run,
    useShallow((state) => stationaryRobot(challenge, state)),
  );
  const maze = useStore(workspace, (state) => state.maze);
  const advice = useMemo(
    () => stationary && handAdvice(challenge.goal, maze, stationary),
    [challenge, maze, stationary],
  );
  const hasBumpAbove = useStore(cardDock, (state) => state.hasBump);
  const bump = useStore(cards, (state) => state.bump);
  const isMet = result.state === "met";
  const failure = verdict === null ? null : failureOf(verdict, shown);
  // In a drive by hand the student may continue, so nothing has failed while the result is open.
  const isOpen = failure === null && failedRun === null && result.state === "open";
  const text = isMet
    ? metText(ofRun, challenge, result)
    : failure !== null
      ? failureText(words, challenge, failure, diagnoses[failure.maze ?? -1] ?? null)
      : failedRun !== null
        ? runFailureText(ofRun, failedRun)
        : isOpen && stationary !== null && advice !== null
          ? handText(words, challenge, stationary.reading, advice)
          : liveFailureText(ofRun, challenge, result);
  useAnnouncement(text, "mission");
  useEffect(
    () => () => {
      // Withdraws the text only when another challenge opens or none is open. On a phone the card
      // also unmounts with its tab.
      if (store.getState().challenge !== challenge) speech.announceState("mission", null);
    },
    [store, speech, challenge],
  );
  // The card of the same bump, directly above, shows the same sentence.
  const isRepeated = hasBumpAbove && failedRun !== null && bump?.diagnosis === failedRun;
  const isShown = isMet || failure !== null || !isRepeated;
  return (
    <p
      role="note"
      className={isShown ? styles["outcome"] : "visually-hidden"}
      data-state={isMet ? "met" : isOpen ? "open" : "failed"}
    >
      {text}
    </p>
  );
}

/** The failure in the displayed maze or, if that maze passes, in the first maze that fails. */
function failureOf({ mazes, failure }: Verdict, shown: number): Verdict["failure"] {
  return mazes[shown]?.failure ?? failure;
}
