/** The start of the pages for teachers: what they can do here, and the lessons on this device. */
import { ChartColumn, ListChecks, SquarePen, type IconNode } from "lucide";
import { useTranslation } from "react-i18next";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import { Icon } from "../../ui/Icon.tsx";
import { SavedLessonList } from "./SavedLessonList.tsx";
import { HAND_INS_HASH, MAKE_HASH, REPORT_HASH } from "./frame/teach-view.ts";
import styles from "./teach-home.module.css";

/** Texts of `teach:home.entries`, icon and address of each entry. */
const entries: readonly { id: "make" | "handIns" | "reports"; icon: IconNode; href: string }[] = [
  { id: "make", icon: SquarePen, href: MAKE_HASH },
  { id: "handIns", icon: ListChecks, href: HAND_INS_HASH },
  { id: "reports", icon: ChartColumn, href: REPORT_HASH },
];

export function TeachHome({ device }: { device: KeyValueStorage }) {
  const { t } = useTranslation("teach", { useSuspense: false });
  return (
    <div className={styles["home"]}>
      <h2 className={styles["title"]}>{t("home.title")}</h2>
      <ul className={styles["entries"]}>
        {entries.map(({ id, icon, href }) => (
          <li key={id} className={styles["item"]}>
            <a className={styles["entry"]} href={href}>
              <Icon of={icon} className={styles["icon"]} />
              <span className={styles["name"]}>{t(`home.entries.${id}.name`)}</span>
              <span className={styles["note"]}>{t(`home.entries.${id}.note`)}</span>
            </a>
          </li>
        ))}
      </ul>
      <SavedLessonList device={device} />
      <p className={styles["private"]}>{t("home.private")}</p>
    </div>
  );
}
