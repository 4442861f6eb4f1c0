/** The state of the connection in words, and the button that changes it. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Button } from "../../ui/Button.tsx";
import { classNames } from "../../ui/class-names.ts";
import { useOnline } from "../../ui/use-online.ts";
import { viewConnection, type ConnectionView } from "./connection-view.ts";
import { useNow } from "./use-now.ts";
import panel from "./remote.module.css";
import styles from "./connection-card.module.css";

export function ConnectionCard() {
  const { t } = useTranslation();
  const { remote, connection, run } = useServices();
  const status = useStore(remote, (state) => state.status);
  const isRunPaused = useStore(run, ({ snapshot }) => snapshot?.state === "paused");
  const now = useNow(status.kind === "connected");
  const view = viewConnection(status, isRunPaused, now);
  const isOnline = useOnline();
  const { title, note } = useWords(view);
  const isOpen = view.kind !== "off" && view.kind !== "lost" && view.kind !== "over";
  return (
    <section
      className={classNames(styles["card"], styles[view.kind])}
      aria-label={t("remote.title")}
    >
      <span className={styles["dot"]} aria-hidden="true" />
      <div className={styles["cardWords"]}>
        {/* Screen readers announce only the change of state, not the seconds that count up. */}
        <output className="visually-hidden">{view.kind === "quiet" ? "" : title}</output>
        <p className={styles["cardTitle"]} aria-hidden={view.kind !== "quiet"}>
          {title}
        </p>
        <p className={panel["note"]}>{isOnline ? note : t("offline.offline")}</p>
      </div>
      {isOpen ? (
        <Button size="small" onClick={() => connection.disconnect()}>
          {t("remote.disconnect")}
        </Button>
      ) : (
        <Button size="small" kind="primary" onClick={() => connection.connect()}>
          {view.kind === "off" && t("remote.connect")}
          {view.kind === "lost" && t("remote.connectAgain")}
          {view.kind === "over" && t("remote.newAddress")}
        </Button>
      )}
    </section>
  );
}

function useWords(view: ConnectionView): { title: string; note: string } {
  const { t } = useTranslation(["words", "runDetails"], { useSuspense: false });
  switch (view.kind) {
    case "off":
      return { title: t("remote.off"), note: t("remote.offNote") };
    case "connecting":
      return { title: t("remote.connecting"), note: t("remote.connectingNote") };
    case "waiting":
      return { title: t("remote.waiting"), note: t("remote.waitingNote") };
    case "paused":
      return { title: t("runDetails:remotePaused.title"), note: t("runDetails:remotePaused.note") };
    case "connected":
    case "quiet": {
      // The relay derives the language from the request's headers, or sends "Script".
      const client =
        view.client === "" || view.client === "Script"
          ? t("remote.someScript")
          : t("remote.scriptIn", { language: view.client });
      return view.kind === "connected"
        ? {
            title: t("remote.connected"),
            note: t("remote.active", { client, seconds: view.seconds.toFixed(1) }),
          }
        : {
            title: t("remote.quiet", { seconds: Math.floor(view.seconds) }),
            note: t("remote.quietNote", { client }),
          };
    }
    case "lost":
      return { title: t("remote.lost"), note: t(`remote.trouble.${view.reason}`) };
    case "over":
      return { title: t("remote.over"), note: t(`remote.trouble.${view.reason}`) };
  }
}
