/** The label of a fix's button, with the numbers that the fix changes. */
import type { Fix } from "@corridor/coach";
import { numberOf, type ProgramDocument } from "@corridor/program";
import type { TFunction } from "i18next";

/** @param program the program that the fix was made for */
export function fixText(
  t: TFunction<["diagnosis", "words"]>,
  program: ProgramDocument,
  fix: Fix,
): string {
  switch (fix.kind) {
    case "action": {
      const action = t(`words:program.action.${fix.action}`);
      return fix.line === "default"
        ? t("diagnosis:fix.otherwise", { action })
        : t("words:cards.fix.action", { action });
    }
    case "number": {
      const when = program.rules[fix.line]?.when ?? null;
      const from = when === null ? "" : numberOf(when);
      return t("words:cards.fix.number", { from, number: fix.number });
    }
    case "move":
      return t("words:cards.fix.move", { line: fix.line + 1, to: fix.to + 1 });
    case "insert": {
      const { when, do: action } = fix.rule;
      return t("diagnosis:fix.insert", {
        sensor: t(`words:program.sensor.${when?.sensor ?? "front"}`),
        sign: when?.is ?? "<",
        number: when === null ? "" : numberOf(when),
        action: t(`words:program.action.${action}`),
      });
    }
    case "condition":
      if (fix.when?.sensor !== program.rules[fix.line]?.when?.sensor) {
        const sensor = t(`words:program.sensor.${fix.when?.sensor ?? "front"}`);
        return t("diagnosis:fix.sensor", { sensor, line: fix.line + 1 });
      }
      return t("diagnosis:fix.comparison", { sign: fix.when?.is ?? "", line: fix.line + 1 });
    case "delete":
      return t("diagnosis:fix.delete", { line: fix.line + 1 });
  }
}
