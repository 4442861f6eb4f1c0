/**
 * The page while the work that its address asks for is on its way: its frames, and what there is to say.
 * Another work would be taken for the one that was asked for.
 */
import { useTranslation } from "react-i18next";
import { Messages } from "../features/messages/Messages.tsx";
import { SpokenRun } from "../features/speech/SpokenRun.tsx";
import page from "./app.module.css";
import { Brand } from "./Brand.tsx";
import styles from "./empty-house.module.css";
import sheet from "./phone-sheet.module.css";
import panel from "./side-panel.module.css";
import bar from "./top-bar.module.css";

export function EmptyHouse() {
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
