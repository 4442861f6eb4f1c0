/** The name that the student has in the class, and the way into the student's page. */
import type { JoinedClass } from "@corridor/protocol";
import { useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { studentNameText } from "../../model/classes/student-name.ts";
import buttons from "../../ui/button.module.css";
import { classNames } from "../../ui/class-names.ts";
import styles from "./join.module.css";

export function JoinedClassCard({ joined }: { joined: JoinedClass }) {
  const { t } = useTranslation("join", { useSuspense: false });
  const title = useRef<HTMLHeadingElement>(null);
  // The form is gone: the focus moves to what replaced it.
  useEffect(() => title.current?.focus(), []);
  return (
    <section className={styles["card"]}>
      <h1 ref={title} className={styles["title"]} tabIndex={-1}>
        {t("youAre")} <bdi className={styles["name"]}>{studentNameText(joined.name)}</bdi>
      </h1>
      <p className={styles["text"]}>{t("noAccount")}</p>
      <p className={styles["text"]}>{t("ownMazes")}</p>
      <div className={styles["actions"]}>
        <a className={classNames(buttons["button"], buttons["primary"], buttons["large"])} href="/">
          {t("start")}
        </a>
      </div>
      <details className={styles["more"]}>
        <summary>{t("teacherSees")}</summary>
        <p className={styles["text"]}>{t("teacherSeesText")}</p>
      </details>
    </section>
  );
}
