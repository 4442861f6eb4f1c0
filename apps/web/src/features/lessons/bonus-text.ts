/** Texts of a bonus mission: its current state and the best result. */
import type { BonusAnswers } from "../../simulator/protocol/bonus-request.ts";
import { formatSeconds } from "../../text/numbers.ts";
import type { MissionWords } from "../../model/lessons/mission-words.ts";
import {
  BONUS_SECONDS,
  bonusMissions,
  type BonusMissionId,
} from "../../model/lessons/missions/bonus-missions.ts";
import type { BonusStatus } from "../../model/lessons/bonus-checker.ts";

/** @returns null if there is nothing to report yet */
export function statusText({ t, i18n }: MissionWords, status: BonusStatus): string | null {
  switch (status.kind) {
    case "none":
      return null;
    case "checking":
      return t("missions:card.checking");
    case "failed":
      return t("words:lessons.notLoaded");
    case "mazes": {
      const { solved, all, ticks } = status.result;
      const seconds = formatSeconds(ticks, i18n.language);
      return t("missions:bonus.mazes", { solved, all, seconds });
    }
    case "hand": {
      const seconds = formatSeconds(status.ticks, i18n.language);
      return t("missions:bonus.hand", { bumps: status.bumps, seconds });
    }
    case "defeat":
      return defeatText({ t, i18n }, status.result);
  }
}

function defeatText({ t, i18n }: MissionWords, result: BonusAnswers["defeat"]): string {
  switch (result.state) {
    case "no-goal":
      return t("missions:bonus.noGoal");
    case "no-path":
      return t("missions:bonus.noPath");
    case "reached":
      return t("missions:bonus.reached", { seconds: formatSeconds(result.ticks, i18n.language) });
    case "defeated":
      return t("missions:bonus.defeated", {
        seconds: BONUS_SECONDS,
        squares: result.squares,
      });
  }
}

/** Whether the bonus mission is currently solved. */
export function isReached(status: BonusStatus): boolean {
  switch (status.kind) {
    case "mazes":
      return status.result.solved === status.result.all;
    case "defeat":
      return status.result.state === "defeated";
    case "hand":
      return true;
    case "none":
    case "checking":
    case "failed":
      return false;
  }
}

/** @param best as the device stores it */
export function bestText(
  { t, i18n }: MissionWords,
  id: BonusMissionId,
  best: readonly number[],
): string {
  const [first = 0, ticks = 0] = best;
  const seconds = formatSeconds(ticks, i18n.language);
  switch (id) {
    case "all-mazes": {
      const all = bonusMissions.find((each) => each.id === id)?.challenge.mazes.length ?? 0;
      return t("missions:bonus.best.all-mazes", { solved: all - first, all, seconds });
    }
    case "fewest-bumps":
      return t("missions:bonus.best.fewest-bumps", { bumps: first, seconds });
    case "beat-right-wall":
      return t("missions:bonus.best.beat-right-wall", { squares: first });
  }
}
