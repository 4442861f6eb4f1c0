/**
 * Replaces the scripts' key after a confirmation, because the service disconnects scripts that use
 * the old key.
 */
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { withNewKey } from "./owner-calls.ts";
import styles from "./new-key.module.css";

interface NewKeyProps {
  session: RemoteSession;
  /** @param isMade whether the service created the key */
  onDone: (isMade: boolean) => void;
}

export function NewKey({ session, onDone }: NewKeyProps) {
  const { t } = useTranslation();
  const { simulator } = useServices();
  const [isAsking, setAsking] = useState(false);
  const make = async (): Promise<void> => {
    setAsking(false);
    const next = await withNewKey(fetch, session);
    // The worker holds the connection. The page stores the session that the worker reports, for a
    // reload.
    if (next !== null) simulator.send({ type: "remote-open", session: next, fresh: false });
    onDone(next !== null);
  };
  return (
    <>
      <button type="button" className={styles["link"]} onClick={() => setAsking(true)}>
        {t("remote.newKey")}
      </button>
      <Dialog
        isOpen={isAsking}
        onClose={() => setAsking(false)}
        title={t("remote.newKeyTitle")}
        width="narrow"
        footer={
          <div className={styles["choices"]}>
            <Button onClick={() => setAsking(false)}>{t("remote.keepKey")}</Button>
            <Button kind="primary" onClick={() => void make()}>
              {t("remote.newKey")}
            </Button>
          </div>
        }
      >
        <p>{t("remote.newKeyNote")}</p>
      </Dialog>
    </>
  );
}
