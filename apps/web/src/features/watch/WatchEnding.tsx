/** Why there is nothing to watch, and what to do next. */
import { useTranslation } from "react-i18next";
import { classNames } from "../../ui/class-names.ts";
import { Button } from "../../ui/Button.tsx";
import buttons from "../../ui/button.module.css";
import type { Ending } from "./watch-store.ts";
import styles from "./watch.module.css";

export function WatchEnding({ ending }: { ending: Ending }) {
  const { t } = useTranslation(["words", "watch"], { useSuspense: false });
  const link = (kind: "primary" | "outline"): string =>
    classNames(buttons["button"], buttons[kind], buttons["large"]);
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
            <a className={link("primary")} href="/">
              {t("watch:open")}
            </a>
          )}
          {ending === "script" && (
            <a className={link("outline")} href="/docs">
              {t("watch:learn")}
            </a>
          )}
        </div>
      </div>
    </main>
  );
}
