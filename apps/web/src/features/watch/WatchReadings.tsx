/** The four readings around the watched robot. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { contactSensor } from "../../stage/drawing/contact-sensor.ts";
import { decimalSign, formatReading } from "../../text/numbers.ts";
import { SensorReadings } from "../../ui/SensorReadings.tsx";
import type { WatchStore } from "./watch-store.ts";

export function WatchReadings({ store }: { store: WatchStore }) {
  const { i18n } = useTranslation();
  const snapshot = useStore(store, (state) => state.snapshot);
  const sign = decimalSign(i18n.language);
  return (
    <SensorReadings
      look="cross"
      touching={contactSensor(snapshot)}
      isBumping={snapshot?.bumping === true}
    >
      {(sensor) => {
        const text =
          snapshot === null ? "–" : formatReading(snapshot.sensors[sensor], i18n.language);
        const [whole = "", tenths] = text.split(sign);
        return (
          <>
            <span>{whole}</span>
            <span>{tenths === undefined ? "" : sign + tenths}</span>
          </>
        );
      }}
    </SensorReadings>
  );
}
