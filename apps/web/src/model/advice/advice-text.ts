/** An advice in words: the reason with its numbers, and what its one button does. */
import type { Advice, Fix } from "@corridor/coach";
import type { Condition } from "@corridor/program";
import type { TFunction } from "i18next";
import { conditionText } from "./condition-text.ts";

export interface AdviceText {
  reason: string;
  /** null if the advice has no fix */
  fix: string | null;
}

/** @param when the condition of the line that the advice is about; null for "otherwise" */
export function adviceText(
  t: TFunction,
  language: string,
  advice: Advice,
  when: Condition | null,
): AdviceText {
  function lineList(lines: readonly number[]): string {
    const list = new Intl.ListFormat(language, { type: "conjunction" });
    return list.format(lines.map((line) => String(line + 1)));
  }

  function reasonText(given: Advice): string {
    const condition = when === null ? "" : conditionText(t, when, language);
    switch (given.kind) {
      case "never-decides": {
        const lines = lineList(given.above);
        const count = given.above.length;
        return given.line === "default"
          ? t("program.advice.otherwise", { count, lines })
          : t("program.advice.neverDecides", { count, condition, lines });
      }
      case "never-true-here": {
        // Rounding up keeps the sentence true.
        return t(`program.advice.neverTrue.${given.limit}`, {
          condition,
          bound: Math.ceil(given.bound),
        });
      }
      case "delayed-about-front": {
        const side = given.side === "left" ? "Left" : "Right";
        const { needs } = given;
        return given.why === "near"
          ? t("program.advice.delayedNear", { condition, needs })
          : t(`program.advice.delayedFree${side}`, { condition });
      }
      case "immediate-into-opening":
        return t("program.advice.intoOpening", { condition, drivesOn: given.drivesOn });
    }
  }

  function fixText(fix: Fix): string {
    switch (fix.kind) {
      case "action":
        return t("program.fix.action", { action: t(`program.action.${fix.action}`) });
      case "number":
        return t("program.fix.number", { number: fix.number });
      case "condition":
        return t("program.fix.condition", {
          condition: conditionText(t, fix.when, language),
        });
      case "move":
        return t(fix.to < fix.line ? "program.fix.moveUp" : "program.fix.moveDown", {
          line: fix.to + 1,
        });
      case "delete":
        return t("program.fix.delete", { line: fix.line + 1 });
      case "insert":
        return t("program.fix.insert");
    }
  }

  return {
    reason: reasonText(advice),
    fix: advice.fix === null ? null : fixText(advice.fix),
  };
}
