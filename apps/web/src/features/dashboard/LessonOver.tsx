/** The page of a class that has ended, with the way to its report. */
import { ChartColumn } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { reportAddress } from "../../model/teaching/saved-reports.ts";
import { Button } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { useDashboard } from "./dashboard-context.ts";
import { useReport, type ReportPlace } from "./use-report.ts";
import styles from "./dashboard.module.css";

interface LessonOverProps {
  /** `refused`: the key is not valid any more */
  kind: "over" | "refused";
  /** of the class; may be empty */
  label: string;
  /** where the teacher saved the report before the end; null: nowhere */
  saved: ReportPlace | null;
}

export function LessonOver({ kind, label, saved }: LessonOverProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const report = useReport(label);
  const hasStudents = useDashboard(({ students }) => students.size > 0);
  const [place, setPlace] = useState(saved);
  const [isFailed, setFailed] = useState(false);
  const open = async (): Promise<void> => {
    // The page still has the results, also where the teacher saved nothing before the end.
    const found = place ?? (await report.saveOnDevice());
    setPlace(found);
    if (typeof found?.id === "string") location.assign(reportAddress(found.id));
  };
  return (
    <div className={styles["ended"]}>
      <output>
        <h1>{t(`${kind}.title`)}</h1>
        <p>{t(`${kind}.text`)}</p>
      </output>
      {kind === "over" && hasStudents && place?.id !== null && (
        <div>
          <Button
            kind="primary"
            icon={<Icon of={ChartColumn} />}
            onClick={() => void open().catch(() => setFailed(true))}
          >
            {t("over.report")}
          </Button>
        </div>
      )}
      <output>
        {isFailed && <p>{t("end.failed")}</p>}
        {place?.id === null && <p>{t("end.savedFile")}</p>}
      </output>
      <p>
        <a href={place?.id === null ? reportAddress() : "/teach"}>
          {t(place?.id === null ? "over.reports" : "toTeach")}
        </a>
      </p>
    </div>
  );
}
