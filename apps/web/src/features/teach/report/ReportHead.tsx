/** What the report is about: the class and its lesson, when it was saved, the letters, the students. */
import { useTranslation } from "react-i18next";
import { shownCode } from "../../../model/classes/shown-code.ts";
import type { ReportFile } from "./report-files.ts";
import styles from "./report.module.css";

interface ReportHeadProps {
  files: readonly ReportFile[];
  /** number of students in the tables */
  students: number;
}

export function ReportHead({ files, students }: ReportHeadProps) {
  const { t, i18n } = useTranslation("report", { useSuspense: false });
  const date = new Intl.DateTimeFormat(i18n.language, { dateStyle: "long", timeStyle: "short" });
  return (
    <div>
      <ul>
        {files.map(({ name, saved }) => (
          <li key={name}>
            <h3 className={styles["heading"]} dir="auto">
              {name || t("saved.unnamed")}
            </h3>
            {saved !== undefined && (
              <p className={styles["facts"]}>
                <span>{t("saved.at", { date: date.format(saved.savedAt) })}</span>
                {saved.code !== "" && (
                  <span>
                    {t("saved.letters")} <bdi dir="ltr">{shownCode(saved.code)}</bdi>
                  </span>
                )}
              </p>
            )}
          </li>
        ))}
      </ul>
      <output className={styles["facts"]}>
        {students === 1 ? t("oneStudent") : t("students", { all: students })}
      </output>
    </div>
  );
}
