/**
 * The page while the work that its address asks for is on its way: its frames, and what there is to say.
 * Another work would be taken for the one that was asked for.
 */
import { useTranslation } from "react-i18next";
import { Messages } from "../features/messages/Messages.tsx";
import { SpokenRun } from "../features/speech/SpokenRun.tsx";
import styles from "./app.module.css";
import { Brand } from "./Brand.tsx";

export function EmptyHouse() {
  const { t } = useTranslation();
  return (
    <div className={styles["page"]}>
      <header className={styles["bar"]}>
        <Brand />
      </header>
      <main className={styles["stage"]}>
        <p className={styles["opening"]}>{t("offline.opening")}</p>
        <Messages />
      </main>
      <div className={styles["footer"]} />
      <div className={`${styles["panel"]} ${styles["emptyPanel"]}`} />
      <div className={`${styles["sheet"]} ${styles["emptySheet"]}`} />
      <SpokenRun />
    </div>
  );
}
