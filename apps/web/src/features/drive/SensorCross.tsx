/** The four readings around the robot, in cm, where the sensors are. */
import { sensorNames } from "@corridor/protocol";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { decimalSign, formatReading } from "../../text/numbers.ts";
import { classNames } from "../../ui/class-names.ts";
import { RobotFace } from "../../ui/RobotFace.tsx";
import styles from "./drive.module.css";
import { readSensors, touchingSensor } from "./sensor-roles.ts";

/** @param look cross: around the robot; row: one line of words, for phones, in whole cm as on the beams */
export function SensorCross({ look }: { look: "cross" | "row" }) {
  const { t, i18n } = useTranslation();
  const { run, workspace } = useServices();
  const snapshot = useStore(run, (state) => state.snapshot);
  const program = useStore(workspace, (state) => state.program);
  const read = readSensors(program, snapshot);
  const touching = touchingSensor(snapshot);
  const isCross = look === "cross";
  const textOf = (centimetres: number): string =>
    isCross ? formatReading(centimetres, i18n.language) : String(Math.round(centimetres));
  return (
    <dl
      className={isCross ? styles["cross"] : styles["row"]}
      aria-label={t("drive.sensorsIn")}
      data-mood={touching === null ? undefined : "bumped"}
    >
      {sensorNames.map((sensor) => (
        <div
          key={sensor}
          className={classNames(
            styles["sensor"],
            styles[sensor],
            read.includes(sensor) && styles["read"],
            touching === sensor && styles["touching"],
          )}
        >
          <dt>{t(`drive.sensor.${sensor}`)}</dt>
          <Reading
            text={snapshot === null ? "–" : textOf(snapshot.sensors[sensor])}
            sign={decimalSign(i18n.language)}
          />
        </div>
      ))}
      {isCross && (
        <div className={styles["robot"]} aria-hidden="true">
          <RobotFace size={42} mood={touching === null ? "driving" : "bumped"} />
        </div>
      )}
    </dl>
  );
}

/** A reading on its decimal sign, which stays in its place while digits come and go. */
function Reading({ text, sign }: { text: string; sign: string }) {
  const [whole = "", tenths] = text.split(sign);
  return (
    <dd>
      <span>{whole}</span>
      <span>{tenths === undefined ? "" : sign + tenths}</span>
    </dd>
  );
}
