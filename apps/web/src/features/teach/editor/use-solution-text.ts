import { useTranslation } from "react-i18next";
import type { Solution } from "../../../model/teaching/solution.ts";
import { secondsOf } from "./lesson-draft.ts";

/** The result of the teacher's solution: "passes: 2 lines, 5.0 s". Null without a solution. */
export function useSolutionText(solution: Solution | null): string | null {
  const { t, i18n } = useTranslation("lessonEditor", { useSuspense: false });
  if (solution === null) return null;
  const format = { minimumFractionDigits: 1, maximumFractionDigits: 1 };
  const seconds = secondsOf(solution.ticks).toLocaleString(i18n.language, format);
  return solution.program === null
    ? t("solve.passesByHand", { seconds })
    : t("solve.passes", { lines: t("start.own", { count: solution.lines }), seconds });
}
