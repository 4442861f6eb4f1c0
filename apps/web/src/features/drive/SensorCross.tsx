/** The four readings of the displayed tick. */
import type { SensorName } from "@corridor/protocol";
import { useLayoutEffect, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { contactSensor } from "../../stage/drawing/contact-sensor.ts";
import type { RunState } from "../../model/run/run-store.ts";
import { decimalSign, formatReading } from "../../text/numbers.ts";
import { followText } from "../../ui/follow-text.ts";
import { LiveText } from "../../ui/LiveText.tsx";
import { SensorReadings } from "../../ui/SensorReadings.tsx";
import { readSensors } from "./sensor-roles.ts";

/** @param look cross: around the robot; row: one line of text, in whole cm as on the beams */
export function SensorCross({ look }: { look: "cross" | "row" }) {
  const { run, deferred, workspace } = useServices();
  const list = useRef<HTMLDListElement>(null);
  const program = useStore(workspace, (state) => state.program);
  // The attribute selects the style of the readings, without a render for each decision.
  useLayoutEffect(() => {
    const names = ({ snapshot }: RunState): string => readSensors(program, snapshot).join(" ");
    return followText(deferred, names, (read) => list.current?.setAttribute("data-reads", read));
  }, [deferred, program]);
  const touching = useStore(run, ({ snapshot }) => contactSensor(snapshot));
  const isBumping = useStore(run, ({ snapshot }) => snapshot?.bumping === true);
  return (
    <SensorReadings look={look} touching={touching} isBumping={isBumping} element={list}>
      {(sensor) => <Reading sensor={sensor} look={look} />}
    </SensorReadings>
  );
}

interface ReadingProps {
  sensor: SensorName;
  look: "cross" | "row";
}

function Reading({ sensor, look }: ReadingProps) {
  const { i18n } = useTranslation();
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
    <>
      <LiveText of={run} text={whole} />
      <LiveText of={run} text={tenths} />
    </>
  );
}
