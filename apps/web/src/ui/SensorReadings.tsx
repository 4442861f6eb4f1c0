/** The four readings in cm, arranged as the sensors are. */
import { sensorNames, type SensorName } from "@corridor/protocol";
import type { ReactNode, Ref } from "react";
import { useTranslation } from "react-i18next";
import { classNames } from "./class-names.ts";
import { RobotFace } from "./RobotFace.tsx";
import styles from "./sensor-readings.module.css";

interface SensorReadingsProps {
  /** cross: around the robot; row: one line of text */
  look: "cross" | "row";
  /** the sensor on the side that touches a wall */
  touching: SensorName | null;
  isBumping: boolean;
  /**
   * for the caller to write `data-reads`: the names of the sensors that the program reads, which
   * are highlighted
   */
  element?: Ref<HTMLDListElement>;
  /**
   * the reading of a sensor in two elements, before and from the decimal sign, which stays in place
   * while the digits change
   */
  children: (sensor: SensorName) => ReactNode;
}

export function SensorReadings(props: SensorReadingsProps) {
  const { look, touching, isBumping, element, children } = props;
  const { t } = useTranslation();
  const isCross = look === "cross";
  return (
    <dl
      ref={element}
      className={isCross ? styles["cross"] : styles["row"]}
      aria-label={t("drive.sensorsIn")}
      data-reads=""
    >
      {sensorNames.map((sensor) => (
        <div
          key={sensor}
          className={classNames(
            styles["sensor"],
            styles[sensor],
            touching === sensor && styles["touching"],
          )}
        >
          <dt>{t(`drive.sensor.${sensor}`)}</dt>
          <dd>{children(sensor)}</dd>
        </div>
      ))}
      {isCross && (
        <div className={styles["robot"]} aria-hidden="true">
          <RobotFace size={42} mood={isBumping ? "bumped" : "driving"} />
        </div>
      )}
    </dl>
  );
}
