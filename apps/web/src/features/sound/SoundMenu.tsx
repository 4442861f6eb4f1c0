/** Sound in the View menu: on or off, the beam to listen to, and the volume. */
import { sensorNames } from "@corridor/protocol";
import { useId, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Checkbox } from "../../ui/Checkbox.tsx";
import { FieldError } from "../../ui/FieldError.tsx";
import { Select } from "../../ui/Select.tsx";
import { soundsOf } from "./sounds.ts";
import styles from "./sound.module.css";

export function SoundMenu() {
  const { t, ready } = useTranslation("sound", { useSuspense: false });
  const { run } = useServices();
  const id = useId();
  const sounds = soundsOf(run);
  const { isOn, beam, volume } = useStore(sounds.choice);
  const [hasFailed, setFailed] = useState(false);
  if (!ready) return null;
  const percent = Math.round(volume * 100);
  return (
    <fieldset className={styles["sound"]} aria-label={t("title")}>
      <Checkbox
        label={t("on")}
        note={t("note")}
        checked={isOn}
        onChange={(isWanted) => {
          if (isWanted) setFailed(!sounds.switchOn());
          else sounds.switchOff();
        }}
      />
      {hasFailed && <FieldError id={`${id}-error`}>{t("failed")}</FieldError>}
      {isOn && (
        <>
          <div className={styles["choice"]}>
            <span aria-hidden="true">{t("beam")}</span>
            <Select
              label={t("beam")}
              value={beam ?? "none"}
              options={[
                ...sensorNames.map((name) => ({ value: name, label: t(`beams.${name}`) })),
                { value: "none" as const, label: t("none") },
              ]}
              onChange={(value) => sounds.setBeam(value === "none" ? null : value)}
            />
          </div>
          <div className={styles["choice"]}>
            <label htmlFor={id}>{t("volume")}</label>
            <input
              id={id}
              type="range"
              className={styles["slider"]}
              min={5}
              max={100}
              step={5}
              value={percent}
              aria-valuetext={t("percent", { percent })}
              onChange={(event) => sounds.setVolume(event.target.valueAsNumber / 100)}
            />
          </div>
        </>
      )}
    </fieldset>
  );
}
