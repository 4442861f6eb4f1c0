/**
 * The page while the project of its address is loading: empty regions and messages. Displaying
 * another project would suggest that it is the requested one.
 */
import { useTranslation } from "react-i18next";
import { Messages } from "../features/messages/Messages.tsx";
import { SpokenRun } from "../features/speech/SpokenRun.tsx";
import page from "./app.module.css";
import { Brand } from "../ui/Brand.tsx";
import styles from "./loading-page.module.css";
import sheet from "./phone-sheet.module.css";
import panel from "./side-panel.module.css";
import bar from "./top-bar.module.css";

export function LoadingPage() {
  const { t } = useTranslation();
  return (
    <div className={page["page"]}>
      <header className={bar["bar"]}>
        <Brand />
      </header>
      <main className={page["stage"]}>
        <p className={styles["opening"]}>{t("offline.opening")}</p>
        <Messages />
      </main>
      <div className={page["footer"]} />
      <div className={`${panel["panel"]} ${panel["empty"]}`} />
      <div className={sheet["sheet"]} />
      <SpokenRun />
    </div>
  );
}
