/** A line's name for those who hear it: its sentence, whether it runs, and its truth with the numbers. */
import type { Rule } from "@corridor/program";
import { useTranslation } from "react-i18next";
import { formatReading } from "../../text/numbers.ts";
import type { LineState } from "./line-state.ts";

/** "Line 1, running: if right is more than 60, delayed right 90. Right is 250, true." */
export function useLineName(index: number, rule: Rule, state: LineState): string {
  const { t } = useTranslation();
  const line = index + 1;
  const head = state.isDeciding
    ? t("program.name.running", { line })
    : t("program.name.resting", { line });
  const action = t(`program.action.${rule.do}`);
  const { when } = rule;
  if (when === null) return `${head} ${t("program.name.nothing")}`;

  const sensor = t(`program.sensor.${when.sensor}`);
  const sentence =
    when.than === "right"
      ? t(when.is === ">" ? "program.name.moreThanRight" : "program.name.lessThanRight", {
          sensor,
          number: when.plus,
          action,
        })
      : t(when.is === ">" ? "program.name.more" : "program.name.less", {
          sensor,
          number: when.than,
          action,
        });
  if (state.truth === null) return `${head} ${sentence}`;
  const truth = t(state.truth.isTrue ? "program.name.isTrue" : "program.name.isFalse", {
    sensor,
    number: formatReading(state.truth.left),
  });
  return `${head} ${sentence} ${truth}`;
}
