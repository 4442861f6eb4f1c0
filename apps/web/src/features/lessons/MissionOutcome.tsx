/** How the attempt at a mission stands: met, or what went wrong, where, and what to try. Spoken as it changes. */
import type { ChallengeDocument, Verdict } from "@corridor/challenge";
import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { useSay } from "../speech/use-say.ts";
import { failureText, handText, liveFailureText, metText, runFailureText } from "./failure-text.ts";
import { standingReading } from "./standing-reading.ts";
import type { MissionWords } from "./mission-words.ts";
import styles from "./lessons.module.css";

export function MissionOutcome({ challenge }: { challenge: ChallengeDocument }) {
  const { t, i18n } = useTranslation(["missions", "words", "diagnosis"], { useSuspense: false });
  const words: MissionWords = { t: t as unknown as MissionWords["t"], i18n };
  const { challenge: store, run, timeline, speech } = useServices();
  // Of a check nothing waits.
  const ofRun: MissionWords = { ...words, waited: (tick) => timeline.waitedUpTo(tick) };
  const result = useStore(store, (state) => state.result);
  const verdict = useStore(store, (state) => state.verdict);
  const diagnoses = useStore(store, (state) => state.diagnoses);
  const failedRun = useStore(store, (state) => state.failedRun);
  const shown = useStore(store, (state) => state.maze);
  const standing = useStore(run, (state) => standingReading(challenge, state));
  const isMet = result.state === "met";
  const failure = verdict === null ? null : failureOf(verdict, shown);
  // Nothing has failed where a hand may drive on.
  const isOpen = failure === null && failedRun === null && result.state === "open";
  const text = isMet
    ? metText(ofRun, challenge, result)
    : failure !== null
      ? failureText(words, challenge, failure, diagnoses[failure.maze ?? -1] ?? null)
      : failedRun !== null
        ? runFailureText(ofRun, failedRun)
        : isOpen && standing !== null
          ? handText(words, challenge, standing)
          : liveFailureText(ofRun, challenge, result);
  useSay(text, "mission");
  useEffect(
    () => () => {
      // Another one is open, or none: on a phone the card goes with its tab as well.
      if (store.getState().challenge !== challenge) speech.tellState("mission", null);
    },
    [store, speech, challenge],
  );
  return (
    <p
      role="note"
      className={styles["outcome"]}
      data-state={isMet ? "met" : isOpen ? "open" : "failed"}
    >
      {text}
    </p>
  );
}

/** What failed in the maze on the screen; where it passes, in the first one that fails. */
function failureOf({ mazes, failure }: Verdict, shown: number): Verdict["failure"] {
  return mazes[shown]?.failure ?? failure;
}
