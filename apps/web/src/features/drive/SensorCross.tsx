/** The four readings in cm, arranged as the sensors are. */
import { sensorNames, type SensorName } from "@corridor/protocol";
import { useLayoutEffect, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { contactSensor } from "../../stage/drawing/contact-sensor.ts";
import type { RunState } from "../../model/run/run-store.ts";
import { decimalSign, formatReading } from "../../text/numbers.ts";
import { classNames } from "../../ui/class-names.ts";
import { followText } from "../../ui/follow-text.ts";
import { LiveText } from "../../ui/LiveText.tsx";
import { RobotFace } from "../../ui/RobotFace.tsx";
import styles from "./sensor-cross.module.css";
import { readSensors } from "./sensor-roles.ts";

/** @param look cross: around the robot; row: one line of text, in whole cm as on the beams */
export function SensorCross({ look }: { look: "cross" | "row" }) {
  const { t } = useTranslation();
  const { run, workspace } = useServices();
  const list = useRef<HTMLDListElement>(null);
  const program = useStore(workspace, (state) => state.program);
  // The attribute selects the style of the readings, without a render for each decision.
  useLayoutEffect(() => {
    const names = ({ snapshot }: RunState): string => readSensors(program, snapshot).join(" ");
    return followText(run, names, (read) => list.current?.setAttribute("data-reads", read));
  }, [run, program]);
  const touching = useStore(run, ({ snapshot }) => contactSensor(snapshot));
  const isBumping = useStore(run, ({ snapshot }) => snapshot?.bumping === true);
  const isCross = look === "cross";
  return (
    <dl
      ref={list}
      className={isCross ? styles["cross"] : styles["row"]}
      aria-label={t("drive.sensorsIn")}
      data-mood={isBumping ? "bumped" : undefined}
    >
      {sensorNames.map((sensor) => (
        <Sensor key={sensor} sensor={sensor} look={look} isTouching={touching === sensor} />
      ))}
      {isCross && (
        <div className={styles["robot"]} aria-hidden="true">
          <RobotFace size={42} mood={isBumping ? "bumped" : "driving"} />
        </div>
      )}
    </dl>
  );
}

interface SensorProps {
  sensor: SensorName;
  look: "cross" | "row";
  isTouching: boolean;
}

/** A reading that is aligned at its decimal sign, which does not move while digits come and go. */
function Sensor({ sensor, look, isTouching }: SensorProps) {
  const { t, i18n } = useTranslation();
  const { run } = useServices();
  const { language } = i18n;
  const [whole, tenths] = useMemo(() => {
    const textOf = ({ snapshot }: RunState): string => {
      if (snapshot === null) return "–";
      const centimetres = snapshot.sensors[sensor];
      return look === "cross"
        ? formatReading(centimetres, language)
        : String(Math.round(centimetres));
    };
    const sign = decimalSign(language);
    return [
      (state: RunState): string => textOf(state).split(sign)[0] ?? "",
      (state: RunState): string => {
        const digits = textOf(state).split(sign)[1];
        return digits === undefined ? "" : sign + digits;
      },
    ];
  }, [sensor, look, language]);
  return (
    <div className={classNames(styles["sensor"], styles[sensor], isTouching && styles["touching"])}>
      <dt>{t(`drive.sensor.${sensor}`)}</dt>
      <dd>
        <LiveText of={run} text={whole} />
        <LiveText of={run} text={tenths} />
      </dd>
    </div>
  );
}
