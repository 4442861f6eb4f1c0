/** What a button does that mends a bump, with the numbers that it changes. */
import type { Mend } from "@corridor/coach";
import { numberOf, type ProgramDocument } from "@corridor/program";
import type { TFunction } from "i18next";

/** @param program the one that the mend was made for */
export function mendText(t: TFunction, program: ProgramDocument, mend: Mend): string {
  switch (mend.kind) {
    case "action":
      return t("cards.mend.action", { action: t(`program.action.${mend.action}`) });
    case "number": {
      const when = program.rules[mend.line]?.when ?? null;
      const from = when === null ? "" : numberOf(when);
      return t("cards.mend.number", { from, number: mend.number });
    }
    case "move":
      return t("cards.mend.move", { line: mend.line + 1, to: mend.to + 1 });
    case "insert": {
      const { when, do: action } = mend.rule;
      return t("cards.mend.insert", {
        sensor: t(`program.sensor.${when?.sensor ?? "front"}`),
        number: when === null ? "" : numberOf(when),
        action: t(`program.action.${action}`),
      });
    }
    case "condition":
    case "delete":
      throw new RangeError(`No bump is mended by "${mend.kind}".`);
  }
}
