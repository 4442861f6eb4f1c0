/** The Drive tab of the phone: readings in a row, big keys under the thumbs, and who drives. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { DrivePad } from "./DrivePad.tsx";
import styles from "./drive.module.css";
import type { HoldStore } from "./hold-store.ts";
import { SensorCross } from "./SensorCross.tsx";

export function DriveTab({ hold }: { hold: HoldStore }) {
  const { t } = useTranslation();
  const { run } = useServices();
  const driver = useStore(run, ({ snapshot }) => snapshot?.driver ?? "program");
  return (
    <div className={styles["tab"]}>
      <div className={styles["tabHead"]}>
        <h2 className={styles["caption"]}>{t("drive.hold")}</h2>
        <p className={styles["says"]}>{t(`drive.says.${driver}`)}</p>
        <SensorCross look="row" />
      </div>
      <DrivePad hold={hold} caps="words" />
    </div>
  );
}
