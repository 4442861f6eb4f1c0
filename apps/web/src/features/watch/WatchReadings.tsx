/** The four readings around the robot in cm, at the positions of the sensors. */
import { sensorNames } from "@corridor/protocol";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { contactSensor } from "../../stage/drawing/contact-sensor.ts";
import { decimalSign, formatReading } from "../../text/numbers.ts";
import { classNames } from "../../ui/class-names.ts";
import { RobotFace } from "../../ui/RobotFace.tsx";
import styles from "../drive/sensor-cross.module.css";
import type { WatchStore } from "./watch-store.ts";

export function WatchReadings({ store }: { store: WatchStore }) {
  const { t, i18n } = useTranslation();
  const snapshot = useStore(store, (state) => state.snapshot);
  const touching = contactSensor(snapshot);
  const sign = decimalSign(i18n.language);
  return (
    <dl className={styles["cross"]} aria-label={t("drive.sensorsIn")} data-reads="">
      {sensorNames.map((sensor) => {
        const text =
          snapshot === null ? "–" : formatReading(snapshot.sensors[sensor], i18n.language);
        const [whole = "", tenths] = text.split(sign);
        return (
          <div
            key={sensor}
            className={classNames(
              styles["sensor"],
              styles[sensor],
              touching === sensor && styles["touching"],
            )}
          >
            <dt>{t(`drive.sensor.${sensor}`)}</dt>
            {/* Aligned at the decimal sign, which stays in place while the digits change. */}
            <dd>
              <span>{whole}</span>
              <span>{tenths === undefined ? "" : sign + tenths}</span>
            </dd>
          </div>
        );
      })}
      <div className={styles["robot"]} aria-hidden="true">
        <RobotFace size={42} mood={snapshot?.bumping === true ? "bumped" : "driving"} />
      </div>
    </dl>
  );
}
