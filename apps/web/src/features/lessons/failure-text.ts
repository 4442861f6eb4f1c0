/** Why an attempt does not pass, in a sentence with its numbers. */
import type { ChallengeDocument, Failure } from "@corridor/challenge";
import type { TFunction } from "i18next";
import type { ChallengeResult } from "../../stores/challenge-store.ts";
import { formatSeconds } from "../../text/numbers.ts";

/** What `useTranslation` gives: the words, and the language that they are in. */
export interface MissionWords {
  t: TFunction<["missions", "words"]>;
  i18n: { language: string };
}

function lineName({ t }: MissionWords, line: Failure["line"]): string {
  return typeof line === "number"
    ? t("missions:failure.line", { line: line + 1 })
    : t("missions:failure.otherwise");
}

/** What a check says. */
export function failureText(
  words: MissionWords,
  challenge: ChallengeDocument,
  it: Failure,
): string {
  const reason = reasonText(words, challenge, it);
  if (it.maze === null || challenge.mazes.length === 1) return reason;
  return words.t("missions:failure.inMaze", { number: it.maze + 1, reason });
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
      return t("missions:failure.action-not-allowed", { line: lineName(words, it.line) });
    case "changed":
      return t("missions:failure.changed", { line: lineName(words, it.line) });
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

/** That it is met, and with what. */
export function metText(
  { t, i18n }: MissionWords,
  { allowed }: ChallengeDocument,
  result: Extract<ChallengeResult, { state: "met" }>,
): string {
  return result.driver === "program"
    ? t("missions:bar.met", { found: result.lines, needed: allowed.lines })
    : t("missions:bar.metByHand", { seconds: formatSeconds(result.ticks, i18n.language) });
}
