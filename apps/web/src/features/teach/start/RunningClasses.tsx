/** The classes that this device runs: a closed tab loses no lesson. */
import { Users } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { OwnClasses } from "../../../model/classroom/own-classes.ts";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { ButtonLink } from "../../../ui/ButtonLink.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import styles from "../frame/device-list.module.css";

export function RunningClasses({ device }: { device: KeyValueStorage }) {
  const { t, i18n } = useTranslation("teach", { useSuspense: false });
  const [classes] = useState(() => new OwnClasses(device, () => Date.now()).list());
  if (classes.length === 0) return null;
  const time = new Intl.DateTimeFormat(i18n.language, { timeStyle: "short" });
  return (
    <section className={styles["section"]} aria-labelledby="running-classes">
      <h3 id="running-classes" className={styles["heading"]}>
        {t("class.running")}
      </h3>
      <ul className={styles["list"]}>
        {classes.map(({ id, label, startedAt }) => (
          <li key={id} className={styles["row"]}>
            <Icon of={Users} size={20} />
            <span className={styles["words"]}>
              <strong dir="auto">{label || t("class.unnamed")}</strong>
              <span className={styles["note"]}>
                {t("class.since", { time: time.format(startedAt) })}
              </span>
            </span>
            <ButtonLink size="small" href={`/class/${id}`}>
              {t("class.open")}
            </ButtonLink>
          </li>
        ))}
      </ul>
    </section>
  );
}
