/** A line's name for those who hear it: its sentence, whether it runs, and its truth with the numbers. */
import type { Rule } from "@corridor/program";
import { useTranslation } from "react-i18next";
import type { ShownTruth } from "./line-state.ts";

/** "Line 1, running: if right is more than 60, delayed right 90. Right is 250, true." */
export function useLineName(
  index: number,
  rule: Rule,
  isDeciding: boolean,
  truth: ShownTruth | null,
): string {
  const { t } = useTranslation();
  const line = index + 1;
  const head = isDeciding
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
  if (truth === null) return `${head} ${sentence}`;
  const told = t(truth.isTrue ? "program.name.isTrue" : "program.name.isFalse", {
    sensor: t(`program.sensorFirst.${when.sensor}`),
    number: truth.left,
  });
  return `${head} ${sentence} ${told}`;
}
