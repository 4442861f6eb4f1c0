/**
 * The pinned foot of the panel: sensors and drive keys side by side. It is one row of readings
 * while a long program drives beside the stage, or in a mission that refuses the driver Me.
 */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import { useRights } from "../../model/use-rights.ts";
import { DrivePad } from "./DrivePad.tsx";
import { isHandRefused } from "./hand-control.ts";
import styles from "./drive-foot.module.css";
import type { HoldStore } from "./hold-store.ts";
import { SensorCross } from "./SensorCross.tsx";

export function DriveFoot({ hold }: { hold: HoldStore }) {
  const { t } = useTranslation();
  if (useIsCompact()) {
    return (
      <section className={styles["compact"]} aria-label={t("drive.sensors")}>
        <SensorCross look="row" />
        <span className={styles["unit"]}>{t("drive.cm")}</span>
      </section>
    );
  }
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

/** Number of lines that fit above sensors and keys in the smallest window of this layout. */
const FEW_LINES = 3;

/**
 * Depends on nothing that changes by itself while a program drives, so that no line moves
 * meanwhile.
 */
function useIsCompact(): boolean {
  const { run, workspace } = useServices();
  const rights = useRights();
  const isBeside = useMediaQuery("(min-width: 56.25em)");
  const isProgram = useStore(run, ({ snapshot }) => (snapshot?.driver ?? "program") === "program");
  const isLong = useStore(workspace, ({ program }) => program.rules.length > FEW_LINES);
  const isRefused = useStore(run, (state) => isHandRefused(state, rights));
  return isRefused || (isProgram && isBeside && isLong);
}
