/** What stands on the screen when the page cannot open yet, because a file of it did not come. */
import { useTranslation } from "react-i18next";
import { Button } from "../ui/Button.tsx";
import styles from "./app.module.css";

export function LoadFailure({ onRetry }: { onRetry: () => void }) {
  const { t } = useTranslation();
  return (
    <main className={styles["failure"]} role="alert">
      <h1>{t("offline.pageFailedTitle")}</h1>
      <p>{t("offline.pageFailed")}</p>
      <Button kind="primary" size="large" onClick={onRetry}>
        {t("offline.tryAgain")}
      </Button>
    </main>
  );
}
