/** Why an attempt does not pass, in a sentence with its numbers. */
import type { ChallengeDocument, Failure } from "@corridor/challenge";
import { TICKS_PER_SECOND } from "@corridor/simulation";
import type { TFunction } from "i18next";
import type { ChallengeResult } from "../../stores/challenge-store.ts";

export type MissionWords = TFunction<["missions", "words"]>;

/** Seconds with one digit, as the clock has them. */
function secondsOf(ticks: number | null): string {
  return ((ticks ?? 0) / TICKS_PER_SECOND).toFixed(1);
}

function lineName(t: MissionWords, line: Failure["line"]): string {
  return typeof line === "number"
    ? t("missions:failure.line", { line: line + 1 })
    : t("missions:failure.otherwise");
}

/** What a check says. */
export function failureText(t: MissionWords, challenge: ChallengeDocument, it: Failure): string {
  const reason = reasonText(t, challenge, it);
  if (it.maze === null || challenge.mazes.length === 1) return reason;
  return t("missions:failure.inMaze", { number: it.maze + 1, reason });
}

function reasonText(t: MissionWords, challenge: ChallengeDocument, it: Failure): string {
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
      return t("missions:failure.action-not-allowed", { line: lineName(t, it.line) });
    case "changed":
      return t("missions:failure.changed", { line: lineName(t, it.line) });
    case "bump":
      return bumpText(t, it);
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

function bumpText(t: MissionWords, { tick, place, line, decision }: Failure): string {
  const seconds = secondsOf(tick);
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
  t: MissionWords,
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
      return t("missions:failure.bumpLive", { seconds: secondsOf(result.tick) });
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
  t: MissionWords,
  { allowed }: ChallengeDocument,
  result: Extract<ChallengeResult, { state: "met" }>,
): string {
  return result.driver === "program"
    ? t("missions:bar.met", { found: result.lines, needed: allowed.lines })
    : t("missions:bar.metByHand", { seconds: secondsOf(result.ticks) });
}
