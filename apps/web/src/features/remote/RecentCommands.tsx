/** The running command of a script, and the last five that ended. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { CommandTable } from "./CommandTable.tsx";
import { recentCommands } from "./recent-commands.ts";
import { useSelectedCommand } from "./use-selected-command.ts";
import styles from "./remote.module.css";

export function RecentCommands() {
  const { t } = useTranslation();
  const { remote } = useServices();
  const commands = useStore(remote, (state) => state.commands);
  const { listed, waiting } = recentCommands(commands, useSelectedCommand());
  return (
    <section className={styles["section"]} aria-labelledby="commands-heading">
      <div className={styles["bar"]}>
        <h2 id="commands-heading" className={styles["heading"]}>
          {t("remote.commands")}
        </h2>
        <span className={styles["note"]}>
          {waiting === 0 ? t("remote.newestFirst") : t("remote.waitingCommands", { waiting })}
        </span>
      </div>
      {commands.length === 0 ? (
        <p className={styles["note"]}>{t("remote.noCommands")}</p>
      ) : (
        <CommandTable commands={listed} />
      )}
    </section>
  );
}
