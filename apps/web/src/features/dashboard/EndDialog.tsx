/** Ends the lesson: the service then deletes all its data. */
import { Check, Download } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { ProblemNote } from "../../ui/ProblemNote.tsx";
import { reportAddress } from "../../model/teaching/saved-reports.ts";
import { useContent } from "./dashboard-context.ts";
import { useReport, type ReportPlace } from "./use-report.ts";
import styles from "./end-dialog.module.css";

interface EndDialogProps {
  isOpen: boolean;
  onClose: () => void;
  /** of the class; may be empty */
  label: string;
  /** where the teacher saved the report; null: nowhere yet */
  saved: ReportPlace | null;
  onSaved: (place: ReportPlace | null) => void;
}

export function EndDialog({ isOpen, onClose, label, saved, onSaved }: EndDialogProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { calls, report } = useContent();
  const classReport = useReport(label);
  const [isFailed, setFailed] = useState(false);
  const isSaved = saved !== null;
  const end = async (): Promise<void> => {
    const refusal = await calls.end();
    if (refusal !== null) onClose();
    report(refusal);
  };
  return (
    <Dialog
      isOpen={isOpen}
      onClose={() => {
        // The class goes on: the report that was saved is not its last one.
        onSaved(null);
        setFailed(false);
        onClose();
      }}
      title={t("end.title")}
      width="narrow"
      footer={
        <div className={styles["answers"]}>
          <Button
            kind={isSaved ? "outline" : "primary"}
            icon={<Icon of={Download} />}
            onClick={() =>
              void classReport.save().then(
                (place) => {
                  onSaved(place);
                  setFailed(place === null);
                },
                () => setFailed(true),
              )
            }
          >
            {t("end.save")}
          </Button>
          <Button kind={isSaved ? "primary" : "outline"} onClick={() => void end()}>
            {t("end.end")}
          </Button>
        </div>
      }
    >
      <div className={styles["text"]}>
        <p>{t("end.text")}</p>
        {isFailed && (
          <ProblemNote>
            <p>{t("end.failed")}</p>
          </ProblemNote>
        )}
        <output>
          {isSaved && (
            <span className={styles["saved"]}>
              <Icon of={Check} size={18} />
              {t(saved.id === null ? "end.savedFile" : "end.saved")}
            </span>
          )}
        </output>
        {typeof saved?.id === "string" && (
          <p>
            <a href={reportAddress(saved.id)} target="_blank" rel="noreferrer">
              {t("over.report")}
            </a>
          </p>
        )}
      </div>
    </Dialog>
  );
}
