/** Instead of the dashboard, while the class was not reached yet: without a network. */
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
import { useDashboard } from "./dashboard-context.ts";
import styles from "./dashboard.module.css";

export function ClassUnreached() {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const isUnreached = useDashboard(
    ({ classroom, status }) => classroom === null && status.kind === "lost",
  );
  if (!isUnreached) return null;
  return (
    <div className={styles["ended"]} role="alert">
      <h1>{t("unreached.title")}</h1>
      <p>{t("unreached.text")}</p>
      <p>
        <Button onClick={() => location.reload()}>{t("unreached.again")}</Button>
      </p>
    </div>
  );
}
