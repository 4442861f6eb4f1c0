/** The time and the bumps at the displayed tick, and a text if the past is displayed. */
import { History } from "lucide";
import { useCallback } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import type { RunState } from "../../model/run/run-store.ts";
import { formatClock } from "../../text/numbers.ts";
import { Icon } from "../../ui/Icon.tsx";
import { LiveText } from "../../ui/LiveText.tsx";
import styles from "./transport.module.css";

export function Clock() {
  const { t, i18n } = useTranslation();
  const { run } = useServices();
  const { language } = i18n;
  // The clock of a script counts its driving. Its waiting is displayed separately.
  const isApart = useStore(run, (state) => state.waited > 0 || state.snapshot?.driver === "remote");
  const time = useCallback(
    ({ snapshot, waited }: RunState) => {
      const driven = formatClock((snapshot?.tick ?? 0) - waited, language);
      return isApart ? t("shell.run.driving", { time: driven }) : driven;
    },
    [language, isApart, t],
  );
  const waiting = useCallback(
    ({ waited }: RunState) => t("shell.run.waiting", { time: formatClock(waited, language) }),
    [language, t],
  );
  const bumps = useStore(run, ({ snapshot }) => snapshot?.bumps ?? 0);
  const view = useStore(run, (state) => state.view);
  return (
    <p className={styles["clock"]} data-apart={isApart || undefined}>
      <span className={styles["time"]}>
        <span className="live-box">
          <span className="visually-hidden">{t("shell.run.time")} </span>
          <LiveText of={run} text={time} />
        </span>
      </span>
      {isApart && (
        <span className={styles["waiting"]}>
          <span className="live-box">
            <LiveText of={run} text={waiting} />
          </span>
        </span>
      )}
      {view !== "now" && (
        <span className={styles["past"]}>
          <Icon of={History} size={12} />
          {t(`timeline.${view}`)}
        </span>
      )}
      <span className={styles["bumps"]}>{t("shell.run.bumps", { count: bumps })}</span>
    </p>
  );
}
