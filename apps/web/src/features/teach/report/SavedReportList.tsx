/** The reports that the teacher saved on this device. */
import { Trash2 } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import {
  REPORT_HASH,
  reportName,
  type SavedReport,
  type SavedReports,
} from "../../../model/teaching/saved-reports.ts";
import { Button, IconButton } from "../../../ui/Button.tsx";
import { ButtonLink } from "../../../ui/ButtonLink.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import entries from "../frame/device-list.module.css";

export function SavedReportList({ reports }: { reports: SavedReports }) {
  const { t, i18n } = useTranslation(["report", "teach"], { useSuspense: false });
  const [list, setList] = useState(() => reports.list());
  const [deleted, setDeleted] = useState<SavedReport | null>(null);
  if (list.length === 0 && deleted === null) return null;
  const date = new Intl.DateTimeFormat(i18n.language, { dateStyle: "medium", timeStyle: "short" });
  const nameOf = ({ label, lesson }: SavedReport): string =>
    label || lesson || t("teach:lesson.unnamed");
  // A class can have reports of several lessons.
  const fullNameOf = (report: SavedReport): string =>
    reportName(report) || t("teach:lesson.unnamed");
  return (
    <section className={entries["section"]} aria-labelledby="saved-reports">
      <h3 id="saved-reports" className={entries["heading"]}>
        {t("teach:saved.heading")}
      </h3>
      <output className={entries["deleted"]}>
        {deleted !== null && (
          <>
            {t("teach:saved.deleted", { name: fullNameOf(deleted) })}
            <Button
              size="small"
              onClick={() => {
                reports.write(deleted);
                setDeleted(null);
                setList(reports.list());
              }}
            >
              {t("teach:saved.undo")}
            </Button>
          </>
        )}
      </output>
      <ul className={entries["list"]} hidden={list.length === 0}>
        {list.map((report) => (
          <li key={report.id} className={entries["row"]}>
            <span className={entries["words"]}>
              <strong dir="auto">{nameOf(report)}</strong>
              <span className={entries["note"]}>
                {report.label !== "" && report.lesson !== "" && <bdi>{report.lesson}, </bdi>}
                {date.format(report.savedAt)}
              </span>
            </span>
            <span className={entries["actions"]}>
              <ButtonLink
                size="small"
                href={`${REPORT_HASH}=${report.id}`}
                aria-label={t("report:saved.openNamed", { name: fullNameOf(report) })}
              >
                {t("teach:saved.open")}
              </ButtonLink>
              <IconButton
                label={t("report:saved.delete", { name: fullNameOf(report) })}
                onClick={() => {
                  reports.remove(report.id);
                  setDeleted(report);
                  setList(reports.list());
                }}
              >
                <Icon of={Trash2} />
              </IconButton>
            </span>
          </li>
        ))}
      </ul>
    </section>
  );
}
