/** Why tables were not opened, and what to do. */
import { TriangleAlert } from "lucide";
import { useTranslation } from "react-i18next";
import { Icon } from "../../../ui/Icon.tsx";
import type { ReportProblem } from "./report-files.ts";
import styles from "../note.module.css";

export function ReportProblems({ problems }: { problems: readonly ReportProblem[] }) {
  const { t } = useTranslation("report", { useSuspense: false });
  if (problems.length === 0) return null;
  return (
    <div className={styles["problem"]} role="alert">
      <Icon of={TriangleAlert} size={18} />
      <ul>
        {problems.map((each) => (
          <li key={each.file}>
            {t(`problems.${each.code}`, { file: each.file })}
            {each.code === "table" && (
              <p className={styles["detail"]}>
                {t("problems.detail", { ...each.problem, path: each.problem.path || each.file })}
              </p>
            )}
          </li>
        ))}
      </ul>
    </div>
  );
}
