/** Opens the report as it is now, and ends the lesson. On a phone, the menu of the bar ends it. */
import { ChartColumn, LogOut } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { reportAddress } from "../../model/teaching/saved-reports.ts";
import { Button } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import { useDashboard } from "./dashboard-context.ts";
import { useReport } from "./use-report.ts";
import styles from "./class-foot.module.css";

interface ClassFootProps {
  /** of the class; may be empty */
  label: string;
  onEnd: () => void;
}

export function ClassFoot({ label, onEnd }: ClassFootProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { saveOnDevice } = useReport(label);
  const hasStudents = useDashboard(({ students }) => students.size > 0);
  const isPhone = useMediaQuery("(max-width: 37.49em)");
  const [note, setNote] = useState<"savedFile" | "failed" | null>(null);
  const openReport = async (): Promise<void> => {
    const place = await saveOnDevice();
    if (place === null) return setNote("failed");
    setNote(place.id === null ? "savedFile" : null);
    if (place.id !== null) window.open(reportAddress(place.id), "_blank", "noopener");
  };
  return (
    <div className={styles["foot"]}>
      <output>{note !== null && t(`end.${note}`)}</output>
      {!isPhone && (
        <Button kind="quiet" icon={<Icon of={LogOut} isDirectional />} onClick={onEnd}>
          {t("end.open")}
        </Button>
      )}
      {hasStudents && (
        <Button
          icon={<Icon of={ChartColumn} />}
          onClick={() => void openReport().catch(() => setNote("failed"))}
        >
          {t("report")}
        </Button>
      )}
    </div>
  );
}
