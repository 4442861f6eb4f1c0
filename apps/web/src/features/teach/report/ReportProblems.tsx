/** Why tables were not opened, and what to do. */
import { useTranslation } from "react-i18next";
import { ProblemDetail, ProblemNote } from "../../../ui/ProblemNote.tsx";
import type { ReportProblem } from "./report-files.ts";

export function ReportProblems({ problems }: { problems: readonly ReportProblem[] }) {
  const { t } = useTranslation("report", { useSuspense: false });
  if (problems.length === 0) return null;
  return (
    <ProblemNote>
      <ul>
        {problems.map((each) => (
          <li key={each.file}>
            {t(`problems.${each.code}`, { file: each.file })}
            {each.code === "table" && (
              <ProblemDetail>
                {t("problems.detail", { ...each.problem, path: each.problem.path || each.file })}
              </ProblemDetail>
            )}
          </li>
        ))}
      </ul>
    </ProblemNote>
  );
}
