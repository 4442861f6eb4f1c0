import { useTranslation } from "react-i18next";
import type { Solution } from "../../../model/teaching/solution.ts";
import { formatSeconds } from "../../../text/numbers.ts";

/** The result of the teacher's solution: "passes: 2 lines, 5.0 s". Null without a solution. */
export function useSolutionText(solution: Solution | null): string | null {
  const { t, i18n } = useTranslation("lessonEditor", { useSuspense: false });
  if (solution === null) return null;
  const seconds = formatSeconds(solution.ticks, i18n.language);
  return solution.program === null
    ? t("solve.passesByHand", { seconds })
    : t("solve.passes", { lines: t("start.own", { count: solution.lines }), seconds });
}
