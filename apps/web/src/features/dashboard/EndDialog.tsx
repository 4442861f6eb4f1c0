/** Ends the lesson: the service then deletes all its data. */
import { Download } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { useContent } from "./dashboard-context.ts";
import { useReport } from "./use-report.ts";
import styles from "./dashboard.module.css";

interface EndDialogProps {
  isOpen: boolean;
  onClose: () => void;
  /** of the class; may be empty */
  label: string;
}

export function EndDialog({ isOpen, onClose, label }: EndDialogProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { calls, report } = useContent();
  const saveReport = useReport(label);
  const [isSaved, setSaved] = useState(false);
  const end = async (): Promise<void> => {
    const refusal = await calls.end();
    if (refusal !== null) onClose();
    report(refusal);
  };
  return (
    <Dialog
      isOpen={isOpen}
      onClose={() => {
        setSaved(false);
        onClose();
      }}
      title={t("end.title")}
      width="narrow"
    >
      <div className={styles["form"]}>
        <p>{t("end.text")}</p>
        <div className={styles["answers"]}>
          <Button
            kind={isSaved ? "outline" : "primary"}
            icon={<Icon of={Download} />}
            onClick={() => void saveReport().then(() => setSaved(true))}
          >
            {t("end.save")}
          </Button>
          <Button kind={isSaved ? "primary" : "outline"} onClick={() => void end()}>
            {t("end.end")}
          </Button>
        </div>
        <output className={styles["note"]}>{isSaved && t("end.saved")}</output>
      </div>
    </Dialog>
  );
}
