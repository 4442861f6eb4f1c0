/** A condition as the menus show it: "left > right + 1". */
import { numberOf, type Condition } from "@corridor/program";
import type { TFunction } from "i18next";
import { localNumber } from "../../text/numbers.ts";

export function conditionText(t: TFunction, condition: Condition, language: string): string {
  const sensor = t(`program.sensor.${condition.sensor}`);
  const other = condition.than === "right" ? `${t("program.sensor.right")} + ` : "";
  return `${sensor} ${condition.is} ${other}${localNumber(String(numberOf(condition)), language)}`;
}
