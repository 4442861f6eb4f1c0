/** The controls of the past: play the recorded run from the displayed tick, or return to now. */
import { Play, SkipForward } from "lucide";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import styles from "./past-bar.module.css";

/**
 * Renders only while the past is displayed.
 * @param race the button that races the run
 */
export function PastBar({ race }: { race: ReactNode }) {
  const { t } = useTranslation();
  const { run, simulator } = useServices();
  const view = useStore(run, (state) => state.view);
  if (view === "now") return null;
  const note = t(`timeline.${view}Note`);
  return (
    <fieldset className={styles["bar"]} aria-label={note} title={note}>
      {view === "past" && (
        <Button
          size="small"
          className={styles["button"]}
          icon={<Icon of={Play} />}
          title={t("timeline.watchNote")}
          onClick={() => simulator.send({ type: "play" })}
        >
          {t("timeline.watch")}
        </Button>
      )}
      <Button
        size="small"
        className={styles["button"]}
        icon={<Icon of={SkipForward} />}
        onClick={() => simulator.send({ type: "now" })}
      >
        {t("timeline.backToNow")}
      </Button>
      <span className={styles["race"]}>{race}</span>
    </fieldset>
  );
}
