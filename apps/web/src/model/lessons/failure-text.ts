/** Why an attempt does not pass, in a sentence with its numbers. */
import type { Failure, Task } from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import type { ChallengeResult } from "../challenge/challenge-store.ts";
import { roundedSides } from "../../text/compared.ts";
import { formatSeconds, localNumber } from "../../text/numbers.ts";
import { diagnosisText, diagnosisWords } from "../diagnosis/diagnosis-text.ts";
import type { MissionWords } from "./mission-words.ts";
import type { HandAdvice } from "./hand-advice.ts";

/** What a failure belongs to, besides its task. */
export interface FailureContext {
  /** name of the unseen maze; null for a given one */
  unseen: string | null;
  /** whether a teacher may have set the time limit: then more time may be enough */
  isLesson: boolean;
}

const inMission: FailureContext = { unseen: null, isLesson: false };

/**
 * The result of a failed check.
 * @param diagnosis why the program fails in this maze; null if nothing ran
 */
export function failureText(
  words: MissionWords,
  challenge: Task,
  it: Failure,
  diagnosis: Diagnosis | null,
  context: FailureContext = inMission,
): string {
  const reason = diagnosed(words, challenge, it, diagnosis, context);
  const { unseen } = context;
  if (unseen !== null) return words.t("missions:lesson.inUnseen", { maze: unseen, reason });
  if (it.maze === null || challenge.mazes.length === 1) return reason;
  return words.t("missions:failure.inMaze", { number: it.maze + 1, reason });
}

function diagnosed(
  words: MissionWords,
  challenge: Task,
  it: Failure,
  diagnosis: Diagnosis | null,
  context: FailureContext,
): string {
  if (diagnosis === null) return reasonText(words, challenge, it, context);
  if (it.code === "bump") return runFailureText(words, diagnosis);
  const isShort = it.code === "not-reached" && diagnosis.cause !== null;
  const happened = isShort
    ? words.t("missions:failure.notInTime", { seconds: challenge.checks.seconds })
    : reasonText(words, challenge, it, context);
  return runFailureText(words, diagnosis, happened);
}

/** Why a run failed, either on the screen or in a check. */
export function runFailureText(
  { t, i18n, waited }: MissionWords,
  diagnosis: Diagnosis,
  happened?: string,
): string {
  return diagnosisText(diagnosisWords(t, i18n.language, waited), diagnosis, happened);
}

function reasonText(
  words: MissionWords,
  challenge: Task,
  it: Failure,
  { isLesson }: FailureContext,
): string {
  const { t } = words;
  const { seconds } = challenge.checks;
  const { found, needed } = missedText(words, it.found ?? 0, it.needed ?? 0);
  switch (it.code) {
    case "driver":
      return t("missions:failure.driver");
    case "too-many-lines":
      return t("missions:failure.too-many-lines", { found, needed });
    case "condition-not-allowed":
      return t("missions:failure.condition-not-allowed", { line: Number(it.line) + 1 });
    case "action-not-allowed":
      return typeof it.line === "number"
        ? t("missions:failure.actionLine", { line: it.line + 1 })
        : t("missions:failure.actionOtherwise");
    case "changed":
      return typeof it.line === "number"
        ? t("missions:failure.changedLine", { line: it.line + 1 })
        : t("missions:failure.changedOtherwise");
    case "bump":
      return t("missions:failure.bumpHand", {
        seconds: formatSeconds(it.tick ?? 0, words.i18n.language),
      });
    case "not-reached":
    case "not-visited":
      return isLesson
        ? t(`missions:lesson.timeLimit.${it.code}`, { found, needed, seconds })
        : t(`missions:failure.${it.code}`, { found, needed, seconds });
    case "too-short":
      return isLesson
        ? t("missions:lesson.timeLimit.too-short", { found, needed, seconds })
        : t("missions:failure.too-short", { found, needed });
    case "not-stopped":
      return t("missions:failure.not-stopped", { found, needed });
  }
}

/** The end of the time of a lesson, where the goal is a place or any other. */
export function timeLimitText({ t }: MissionWords, { goal, checks }: Task): string {
  const { seconds } = checks;
  return goal.kind === "reach"
    ? t("missions:lesson.timeLimit.not-reached", { seconds })
    : t("missions:lesson.timeLimit.late", { seconds });
}

/** The failure of the run on the screen; null while nothing has failed. */
export function liveFailureText(
  words: MissionWords,
  challenge: Task,
  result: ChallengeResult,
  isLesson = false,
): string | null {
  const { t } = words;
  if (result.state !== "failed") return null;
  switch (result.code) {
    case "driver":
      return t(
        challenge.allowed.drivers.includes("me")
          ? "missions:failure.driver"
          : "missions:failure.hand",
      );
    case "bump":
      return t("missions:failure.bumpLive", {
        seconds: secondsOf(words, result.tick),
      });
    case "late":
      if (isLesson) return timeLimitText(words, challenge);
      return t("missions:failure.late", { seconds: challenge.checks.seconds });
    // Program failures come from a check, and the text of the check takes precedence over this one.
    case "edited":
    case "too-many-lines":
    case "condition-not-allowed":
    case "action-not-allowed":
    case "changed":
    case "not-reached":
    case "not-visited":
    case "not-stopped":
    case "too-short":
      return t("missions:failure.edited");
  }
}

/**
 * What to do where a robot stopped by hand.
 * @param reading of the goal's sensor, in cm; null if the goal is a place
 */
export function handText(
  words: MissionWords,
  { goal }: Pick<Task, "goal">,
  reading: number | null,
  advice: HandAdvice,
): string {
  const { t, i18n } = words;
  if (goal.kind !== "stop" || reading === null) return t(`missions:failure.atGoal.${advice}`);
  const { from, to } = goal;
  return t(`missions:failure.atReading.${advice}`, {
    found: missedText(words, reading, reading < from ? from : to).found,
    from: localNumber(String(from), i18n.language),
    to: localNumber(String(to), i18n.language),
  });
}

/** Rounds two different numbers so that the smaller one still reads as smaller. */
function missedText(
  { i18n }: MissionWords,
  left: number,
  right: number,
): { found: string; needed: string } {
  const is = left < right ? "<" : ">";
  const shown = roundedSides({ left, is, right, isTrue: left !== right }, 0);
  const text = (number: number) => localNumber(String(number), i18n.language);
  return { found: text(shown.left), needed: text(shown.right) };
}

/** Success message with the result. */
export function metText(
  words: MissionWords,
  { allowed }: Task,
  result: Extract<ChallengeResult, { state: "met" }>,
): string {
  const { t } = words;
  // Where no line may be written, there is none to count.
  return result.driver === "program" && allowed.lines > 0
    ? t("missions:bar.met", { found: result.lines, needed: allowed.lines })
    : t("missions:bar.metByHand", {
        seconds: secondsOf(words, result.ticks),
      });
}

/** Seconds on the clock, which excludes ticks in which a script made the robot wait. */
function secondsOf({ i18n, waited = () => 0 }: MissionWords, tick: number): string {
  return formatSeconds(tick - waited(tick), i18n.language);
}
