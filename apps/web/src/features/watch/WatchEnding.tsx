/** Why there is nothing to watch, and what to do next. */
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
import { ButtonLink } from "../../ui/ButtonLink.tsx";
import type { Ending } from "./watch-store.ts";
import styles from "./watch.module.css";

export function WatchEnding({ ending }: { ending: Ending }) {
  const { t } = useTranslation(["words", "watch"], { useSuspense: false });
  return (
    <main className={styles["ended"]}>
      <div className={styles["ending"]} role="alert">
        <h2>{t(`watch:endings.${ending}.title`)}</h2>
        <p>{t(`watch:endings.${ending}.text`)}</p>
        <div className={styles["ways"]}>
          {ending === "failed" ? (
            <Button kind="primary" size="large" onClick={() => location.reload()}>
              {t("watch:reload")}
            </Button>
          ) : (
            <ButtonLink kind="primary" size="large" href="/">
              {t("watch:open")}
            </ButtonLink>
          )}
          {ending === "script" && (
            <ButtonLink size="large" href="/docs">
              {t("watch:learn")}
            </ButtonLink>
          )}
        </div>
      </div>
    </main>
  );
}
