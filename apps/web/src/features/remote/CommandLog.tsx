/** Every command in the page's log, newest first. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Button } from "../../ui/Button.tsx";
import { CommandTable } from "./CommandTable.tsx";
import styles from "./remote.module.css";

export function CommandLog() {
  const { t } = useTranslation();
  const { remote, simulator } = useServices();
  const commands = useStore(remote, (state) => state.commands);
  return (
    <section className={styles["section"]} aria-labelledby="log-heading">
      <div className={styles["bar"]}>
        <h2 id="log-heading" className={styles["heading"]}>
          {t("remote.allCommands")}
        </h2>
        <Button
          kind="quiet"
          size="small"
          disabled={commands.length === 0}
          onClick={() => simulator.send({ type: "remote-clear" })}
        >
          {t("remote.clear")}
        </Button>
      </div>
      {commands.length === 0 ? (
        <p className={styles["note"]}>{t("remote.noCommands")}</p>
      ) : (
        <CommandTable commands={commands} />
      )}
    </section>
  );
}
