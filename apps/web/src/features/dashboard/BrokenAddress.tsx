/** Displayed if the address has no key of a class. */
import { useEffect, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { DashboardFrame } from "./DashboardFrame.tsx";
import styles from "./dashboard.module.css";

export function BrokenAddress({ tools }: { tools: ReactNode }) {
  const { t, i18n } = useTranslation("dashboard", { useSuspense: false });
  useEffect(() => {
    document.title = t("title");
  }, [t, i18n.language]);
  return (
    <DashboardFrame bar={null} end={tools}>
      <div className={styles["ended"]}>
        <h1>{t("broken.title")}</h1>
        <p>{t("broken.text")}</p>
        <p>
          <a href="/teach">{t("toTeach")}</a>
        </p>
      </div>
    </DashboardFrame>
  );
}
