/** Why a line bumped, in words: for the card, and for those who hear it. */
import type { BumpStory } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import type { TFunction } from "i18next";

/** "Bump: line 3 ran out of room" */
export function bumpTitle(t: TFunction, line: LineRef | null): string {
  return typeof line === "number"
    ? t("cards.bump.titleLine", { line: line + 1 })
    : t("cards.bump.titleOtherwise");
}

/** "delayed left 90 drives on for 50 cm, then turns. Only 24 cm were free." */
export function bumpReason(
  t: TFunction,
  { kind, side, needs, free }: BumpStory,
  { rules, default: otherwise }: ProgramDocument,
  line: LineRef | null,
): string {
  const action = (typeof line === "number" ? rules[line]?.do : undefined) ?? otherwise;
  const numbers = {
    action: t(`program.action.${action}`),
    needs: Math.round(needs ?? 0),
    free: Math.round(free),
  };
  if (kind === "delay") return t("cards.bump.delay", numbers);
  if (kind === "way-out") return t("cards.bump.wayOut", numbers);
  return t(side === "front" ? "cards.bump.steadyFront" : "cards.bump.steadyBack", numbers);
}
