/** The start of the pages for teachers: what they can do here. */
import { ChartColumn, ListChecks, type IconNode } from "lucide";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import { HAND_INS_HASH, REPORT_HASH } from "./teach-view.ts";
import styles from "./teach-home.module.css";

/** Texts of `teach:home.entries`, icon and address of each entry. */
const entries: readonly { id: "handIns" | "reports"; icon: IconNode; href: string }[] = [
  { id: "handIns", icon: ListChecks, href: HAND_INS_HASH },
  { id: "reports", icon: ChartColumn, href: REPORT_HASH },
];

export function TeachHome() {
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
      <p className={styles["private"]}>{t("home.private")}</p>
    </div>
  );
}
