/** Reports that the scripts of this robot are paused, and resumes them. */
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Button } from "../../ui/Button.tsx";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { pauseDriving } from "./owner-calls.ts";
import panel from "./remote.module.css";
import styles from "./paused-note.module.css";

export function PausedNote({ session }: { session: RemoteSession }) {
  const { t } = useTranslation();
  const { remote } = useServices();
  const isPaused = useStore(remote, (state) => state.isPaused);
  const [isFailed, setFailed] = useState(false);
  if (!isPaused) return null;
  const resume = async (): Promise<void> => {
    setFailed(!(await pauseDriving(fetch, session, false)));
  };
  return (
    <div className={styles["pausedNote"]}>
      <p className={panel["note"]}>{t("remote.pausedNote")}</p>
      <Button size="small" kind="primary" className={panel["long"]} onClick={() => void resume()}>
        {t("remote.letDrive")}
      </Button>
      <output className={panel["note"]}>{isFailed && t("remote.actionFailed")}</output>
    </div>
  );
}
