/** The start of the pages for teachers: what they can do here, and the lessons on this device. */
import { ChartColumn, ListChecks, SquarePen, Users, type IconNode } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import { Icon } from "../../ui/Icon.tsx";
import { SavedLessonList } from "./SavedLessonList.tsx";
import { RunningClasses } from "./start/RunningClasses.tsx";
import { StartClassDialog } from "./start/lazy-start-class-dialog.ts";
import { REPORT_HASH } from "../../model/teaching/saved-reports.ts";
import { HAND_INS_HASH, MAKE_HASH } from "./frame/teach-view.ts";
import styles from "./teach-home.module.css";

/** Texts of `teach:home.entries`, icon and address of each entry. */
const entries: readonly { id: "make" | "handIns" | "reports"; icon: IconNode; href: string }[] = [
  { id: "make", icon: SquarePen, href: MAKE_HASH },
  { id: "handIns", icon: ListChecks, href: HAND_INS_HASH },
  { id: "reports", icon: ChartColumn, href: REPORT_HASH },
];

export function TeachHome({ device }: { device: KeyValueStorage }) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const [isStarting, setStarting] = useState(false);
  return (
    <div className={styles["home"]}>
      <h2 className={styles["title"]}>{t("home.title")}</h2>
      <ul className={styles["entries"]}>
        <li className={styles["item"]} data-entry="class">
          <button type="button" className={styles["entry"]} onClick={() => setStarting(true)}>
            <Icon of={Users} className={styles["icon"]} />
            <span className={styles["name"]}>{t("home.entries.class.name")}</span>
            <span className={styles["note"]}>{t("home.entries.class.note")}</span>
          </button>
        </li>
        {entries.map(({ id, icon, href }) => (
          <li key={id} className={styles["item"]} data-entry={id}>
            <a className={styles["entry"]} href={href}>
              <Icon of={icon} className={styles["icon"]} />
              <span className={styles["name"]}>{t(`home.entries.${id}.name`)}</span>
              <span className={styles["note"]}>{t(`home.entries.${id}.note`)}</span>
            </a>
          </li>
        ))}
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
