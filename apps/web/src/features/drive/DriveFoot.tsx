/** The pinned foot of the panel: sensors and drive keys side by side. */
import { useTranslation } from "react-i18next";
import { DrivePad } from "./DrivePad.tsx";
import styles from "./drive-foot.module.css";
import type { HoldStore } from "./hold-store.ts";
import { SensorCross } from "./SensorCross.tsx";

export function DriveFoot({ hold }: { hold: HoldStore }) {
  const { t } = useTranslation();
  return (
    <div className={styles["foot"]}>
      <section className={styles["half"]} aria-label={t("drive.sensors")}>
        <h2 className={styles["caption"]}>
          {t("drive.sensors")}
          <span>{t("drive.cm")}</span>
        </h2>
        <SensorCross look="cross" />
      </section>
      <div className={styles["half"]}>
        <h2 className={styles["caption"]}>{t("drive.hold")}</h2>
        <DrivePad hold={hold} caps="keyboard" />
      </div>
    </div>
  );
}
