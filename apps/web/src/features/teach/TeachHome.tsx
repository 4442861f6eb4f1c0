/** The start of the pages for teachers: what they can do here, and the lessons on this device. */
import { ChartColumn, ListChecks, SquarePen, Users, type IconNode } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import { Icon } from "../../ui/Icon.tsx";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import { SavedLessonList } from "./SavedLessonList.tsx";
import { RunningClasses } from "./start/RunningClasses.tsx";
import { StartClassDialog } from "./start/lazy-start-class-dialog.ts";
import { REPORT_HASH } from "../../model/teaching/saved-reports.ts";
import { HAND_INS_HASH, MAKE_HASH } from "./frame/teach-view.ts";
import styles from "./teach-home.module.css";

interface HomeEntry {
  /** texts of `teach:home.entries` */
  id: "make" | "class" | "handIns" | "reports";
  icon: IconNode;
  /** null: a dialog */
  href: string | null;
}

const make: HomeEntry = { id: "make", icon: SquarePen, href: MAKE_HASH };
const start: HomeEntry = { id: "class", icon: Users, href: null };
const later: readonly HomeEntry[] = [
  { id: "handIns", icon: ListChecks, href: HAND_INS_HASH },
  { id: "reports", icon: ChartColumn, href: REPORT_HASH },
];

export function TeachHome({ device }: { device: KeyValueStorage }) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const [isStarting, setStarting] = useState(false);
  const isPhone = useMediaQuery("(max-width: 37.49em)");
  // A class starts with a lesson; on a phone, a teacher is in the room with a class.
  const entries = [...(isPhone ? [start, make] : [make, start]), ...later];
  return (
    <div className={styles["home"]}>
      <h2 className={styles["title"]}>{t("home.title")}</h2>
      <ul className={styles["entries"]}>
        {entries.map(({ id, icon, href }) => {
          const content = (
            <>
              <Icon of={icon} className={styles["icon"]} />
              <span className={styles["name"]}>{t(`home.entries.${id}.name`)}</span>
              <span className={styles["note"]}>{t(`home.entries.${id}.note`)}</span>
            </>
          );
          return (
            <li key={id} className={styles["item"]}>
              {href === null ? (
                <button type="button" className={styles["entry"]} onClick={() => setStarting(true)}>
                  {content}
                </button>
              ) : (
                <a className={styles["entry"]} href={href}>
                  {content}
                </a>
              )}
            </li>
          );
        })}
      </ul>
      <RunningClasses device={device} />
      <SavedLessonList device={device} />
      <p className={styles["private"]}>{t("home.private")}</p>
      <StartClassDialog
        isOpen={isStarting}
        lesson={null}
        device={device}
        onClose={() => setStarting(false)}
      />
    </div>
  );
}
