/** Why an attempt does not pass, in a sentence with its numbers. */
import type { ChallengeDocument, Failure } from "@corridor/challenge";
import type { Blame } from "@corridor/coach";
import type { ChallengeResult } from "../../stores/challenge-store.ts";
import { formatSeconds } from "../../text/numbers.ts";
import { blameText } from "./blame-text.ts";
import type { MissionWords } from "./mission-words.ts";

/**
 * What a check says.
 * @param blame which line led the robot astray; null where none can be named
 */
export function failureText(
  words: MissionWords,
  challenge: ChallengeDocument,
  it: Failure,
  blame: Blame | null,
): string {
  const reason =
    blame === null ? reasonText(words, challenge, it) : blamed(words, challenge, it, blame);
  if (it.maze === null || challenge.mazes.length === 1) return reason;
  return words.t("missions:failure.inMaze", { number: it.maze + 1, reason });
}

/** What happened in few words, then why. */
function blamed(
  words: MissionWords,
  challenge: ChallengeDocument,
  it: Failure,
  blame: Blame,
): string {
  return words.t("missions:failure.both", {
    first: happenedText(words, challenge, it, blame),
    second: blameText(words, blame),
  });
}

function happenedText(
  words: MissionWords,
  challenge: ChallengeDocument,
  it: Failure,
  blame: Blame,
): string {
  const { t, i18n } = words;
  // Where only a missing turn is known, the line that drove into the wall is named before it.
  if (it.code === "bump" && blame.kind === "no-turn") return bumpText(words, it);
  if (it.code === "bump") {
    return t("missions:failure.bump", { seconds: formatSeconds(it.tick ?? 0, i18n.language) });
  }
  if (it.code !== "not-reached") return reasonText(words, challenge, it);
  return t("missions:failure.notInTime", { seconds: challenge.checks.seconds });
}

function reasonText(words: MissionWords, challenge: ChallengeDocument, it: Failure): string {
  const { t } = words;
  const found = Math.round(it.found ?? 0);
  const needed = Math.round(it.needed ?? 0);
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
      return bumpText(words, it);
    case "not-reached":
    case "not-visited":
      return t(`missions:failure.${it.code}`, {
        found,
        needed,
        seconds: challenge.checks.seconds,
      });
    case "not-stopped":
    case "too-short":
      return t(`missions:failure.${it.code}`, { found, needed });
  }
}

function bumpText({ t, i18n }: MissionWords, { tick, place, line, decision }: Failure): string {
  const seconds = formatSeconds(tick ?? 0, i18n.language);
  const action = decision?.action;
  if (action === null || action === undefined || place === null) {
    return t("missions:failure.bumpHand", { seconds });
  }
  const known = {
    seconds,
    row: place.row + 1,
    column: place.column + 1,
    action: t(`words:program.action.${action}`),
    front: Math.round(decision?.readings.front ?? 0),
  };
  return typeof line === "number"
    ? t("missions:failure.bumpLine", { ...known, line: line + 1 })
    : t("missions:failure.bumpOtherwise", known);
}

/** What the run on the screen says; null while nothing has failed. */
export function liveFailureText(
  { t, i18n }: MissionWords,
  challenge: ChallengeDocument,
  result: ChallengeResult,
): string | null {
  if (result.state !== "failed") return null;
  switch (result.code) {
    case "driver":
      return t(
        challenge.allowed.drivers.includes("me")
          ? "missions:failure.driver"
          : "missions:failure.hand",
      );
    case "bump":
      return t("missions:failure.bumpLive", { seconds: formatSeconds(result.tick, i18n.language) });
    case "late":
      return t("missions:failure.late", { seconds: challenge.checks.seconds });
    // What the check said of the program stands before this.
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

/** What is lacking where a hand has let go of the robot. @param reading of the sensor that counts, in cm */
export function handText(
  { t }: MissionWords,
  { goal }: ChallengeDocument,
  reading: number,
): string {
  if (goal.kind !== "stop") return t("missions:failure.handStopped");
  const needed = reading < goal.from ? goal.from : goal.to;
  return t("missions:failure.not-stopped", { found: reading, needed });
}

/** That it is met, and with what. */
export function metText(
  { t, i18n }: MissionWords,
  { allowed }: ChallengeDocument,
  result: Extract<ChallengeResult, { state: "met" }>,
): string {
  // Where no line may be written there is none to count.
  return result.driver === "program" && allowed.lines > 0
    ? t("missions:bar.met", { found: result.lines, needed: allowed.lines })
    : t("missions:bar.metByHand", { seconds: formatSeconds(result.ticks, i18n.language) });
}
