/** The band below the bar while the teacher has paused the class. */
import { Pause } from "lucide";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useAnnouncement } from "../../model/use-announcement.ts";
import { joinSentences } from "../../text/joined.ts";
import { Icon } from "../../ui/Icon.tsx";
import styles from "./pause-band.module.css";

/** @param endsAt in milliseconds since 1970 */
export function PauseBand({ endsAt }: { endsAt: number }) {
  const { t } = useTranslation("join", { useSuspense: false });
  const { t: tShared } = useTranslation();
  const left = useSecondsLeft(endsAt);
  const paused = t("inClass.paused");
  const saved = t("inClass.pausedSaved");
  // Without the time: it would be announced every second.
  useAnnouncement(joinSentences(tShared, [paused, saved]), "class paused");
  return (
    <p className={styles["band"]}>
      <Icon of={Pause} size={18} />
      <span>{paused}</span>
      <span className={styles["left"]}>{t("inClass.pausedLeft", { time: clockText(left) })}</span>
      <span>{saved}</span>
    </p>
  );
}

/** @param endsAt ms since 1970 */
function useSecondsLeft(endsAt: number): number {
  const [left, setLeft] = useState(() => secondsUntil(endsAt));
  useEffect(() => {
    const look = (): void => setLeft(secondsUntil(endsAt));
    look();
    const timer = setInterval(look, 1_000);
    return () => clearInterval(timer);
  }, [endsAt]);
  return left;
}

function secondsUntil(endsAt: number): number {
  return Math.max(0, Math.ceil((endsAt - Date.now()) / 1_000));
}

/** "4:32" */
function clockText(seconds: number): string {
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")}`;
}
