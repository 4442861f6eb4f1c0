/** Which line led the robot astray, why, and what to try, in a sentence with its numbers. */
import type { Blame } from "@corridor/coach";
import { formatSeconds } from "../../text/numbers.ts";
import type { MissionWords } from "./mission-words.ts";

export function blameText(words: MissionWords, it: Blame): string {
  const { t } = words;
  switch (it.kind) {
    case "overruled":
      return t("missions:blame.overruled", {
        line: it.line + 1,
        above: it.above + 1,
        seconds: at(words, it.tick),
        sensor: t(`words:program.sensor.${it.sensor}`),
        reading: Math.round(it.reading),
      });
    case "always-true":
      return t("missions:blame.alwaysTrue", {
        line: it.line + 1,
        sensor: t(`words:program.sensor.${it.sensor}`),
        number: it.number,
        nearest: it.nearest,
      });
    case "no-room": {
      const numbers = {
        action: t(`words:program.action.${it.action}`),
        front: Math.round(it.front),
        needs: it.needs,
      };
      return it.line === "default"
        ? t("missions:blame.noRoomOtherwise", numbers)
        : t("missions:blame.noRoom", { ...numbers, line: it.line + 1 });
    }
    case "early-turn":
      return t("missions:blame.earlyTurn", {
        line: it.line + 1,
        action: t(`words:program.action.${it.action}`),
        seconds: at(words, it.tick),
        drivesOn: it.drivesOn,
      });
    case "wall-turn":
      return wallTurnText(words, it);
    case "undoing": {
      const numbers = { line: it.line + 1, front: Math.round(it.front) };
      return it.other === "default"
        ? t("missions:blame.undoingOtherwise", numbers)
        : t("missions:blame.undoing", { ...numbers, other: it.other + 1 });
    }
    case "no-turn":
      return t(`missions:blame.noTurn.${it.side}`, {
        seconds: at(words, it.tick),
        reading: Math.round(it.reading),
      });
    case "nowhere": {
      const { kind, line, times } = it.notice;
      return line === "default"
        ? t(`words:cards.loop.${kind}Otherwise`, { times })
        : t(`words:cards.loop.${kind}Line`, { times, line: line + 1 });
    }
  }
}

function wallTurnText(words: MissionWords, it: Extract<Blame, { kind: "wall-turn" }>): string {
  const { t } = words;
  const numbers = {
    action: t(`words:program.action.${it.action}`),
    seconds: at(words, it.tick),
    side: t(`words:program.sensor.${it.side}`),
    reading: Math.round(it.reading),
    free: Math.round(it.free),
  };
  if (it.open === "front") {
    return it.line === "default"
      ? t("missions:blame.atWallOtherwise", numbers)
      : t("missions:blame.atWall", { ...numbers, line: it.line + 1 });
  }
  const known = { ...numbers, open: t(`words:program.sensor.${it.open}`) };
  const turned =
    it.line === "default"
      ? t("missions:blame.nearerSideOtherwise", known)
      : t("missions:blame.nearerSide", { ...known, line: it.line + 1 });
  if (!it.isMissing) return turned;
  return t("missions:failure.both", {
    first: turned,
    second: t(`missions:blame.noLine.${it.open}`),
  });
}

function at({ i18n }: MissionWords, tick: number): string {
  return formatSeconds(tick, i18n.language);
}
