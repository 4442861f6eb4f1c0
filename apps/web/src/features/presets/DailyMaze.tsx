/** The daily maze among the presets: that of today, or of an earlier day. */
import { dailyMaze, dayAfter, type Day, type MazeDocument } from "@corridor/maze";
import { ChevronLeft, ChevronRight } from "lucide";
import { useId, useState } from "react";
import { useTranslation } from "react-i18next";
import { storageOrNone } from "../../model/storage/key-value-storage.ts";
import { formatClock } from "../../text/numbers.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button, IconButton } from "../../ui/Button.tsx";
import { MazePicture } from "../../ui/MazePicture.tsx";
import { bestOf, EARLIER_DAYS, utcDay } from "../../model/presets/daily-best.ts";
import styles from "./daily.module.css";

export function DailyMaze({ onUse }: { onUse: (maze: MazeDocument) => void }) {
  const { t, i18n, ready } = useTranslation("daily", { useSuspense: false });
  const id = useId();
  const [today] = useState(() => utcDay(new Date()));
  const [back, setBack] = useState(0);
  if (!ready) return null;
  const day = dayAfter(today, -back);
  const maze = dailyMaze(day, t("name", { date: dateText(day, i18n.language) }));
  const best = bestOf(
    storageOrNone(() => localStorage),
    day,
  );
  return (
    <section aria-labelledby={id}>
      <h2 id={id} className={styles["heading"]}>
        {t("title")}
      </h2>
      <div className={styles["daily"]}>
        <span className={styles["picture"]}>
          <MazePicture maze={maze} />
        </span>
        <div className={styles["words"]}>
          <div className={styles["day"]}>
            <IconButton
              label={t("earlier")}
              disabled={back === EARLIER_DAYS}
              onClick={() => setBack(back + 1)}
            >
              <Icon of={ChevronLeft} isDirectional className={styles["arrow"]} />
            </IconButton>
            <output className={styles["name"]}>{maze.name}</output>
            <IconButton label={t("later")} disabled={back === 0} onClick={() => setBack(back - 1)}>
              <Icon of={ChevronRight} isDirectional className={styles["arrow"]} />
            </IconButton>
          </div>
          <p>{t("goal")}</p>
          <p className={styles["best"]}>
            {best === null
              ? t("notYet")
              : t("best", {
                  time: formatClock(best.ticks, i18n.language),
                  bumps: t("bumps", { count: best.bumps }),
                })}
          </p>
          <Button className={styles["use"]} onClick={() => onUse(maze)}>
            {t("use")}
          </Button>
        </div>
      </div>
    </section>
  );
}

/** A date in the user's language, with Latin digits as everywhere on the page. */
function dateText({ year, month, day }: Day, language: string): string {
  const date = new Date(0);
  date.setUTCFullYear(year, month - 1, day);
  return new Intl.DateTimeFormat(language, {
    dateStyle: "long",
    timeZone: "UTC",
    calendar: "gregory",
    numberingSystem: "latn",
  }).format(date);
}
