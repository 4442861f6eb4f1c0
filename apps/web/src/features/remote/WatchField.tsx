/** An address for those who only look on: made when it is asked for, since most robots need none. */
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
import type { RemoteSession } from "../../worker/worker-messages.ts";
import { CopyButton } from "../share/CopyButton.tsx";
import { watchAddress } from "./owner-calls.ts";
import { maskKey } from "./robot-address.ts";
import styles from "./remote.module.css";

export function WatchField({ session }: { session: RemoteSession }) {
  const { t } = useTranslation();
  const [address, setAddress] = useState<string | null>(null);
  const [isFailed, setFailed] = useState(false);
  const make = async (): Promise<void> => {
    const made = await watchAddress(fetch, session);
    setAddress(made);
    setFailed(made === null);
  };
  return (
    <>
      <dt className={styles["label"]}>{t("remote.watch")}</dt>
      {address === null ? (
        <dd>
          <Button size="small" className={styles["long"]} onClick={() => void make()}>
            {t("remote.makeWatch")}
          </Button>
        </dd>
      ) : (
        <dd className={styles["value"]} ref={focusIn}>
          <span dir="ltr" className={styles["mono"]}>
            {maskKey(address)}
          </span>
          <CopyButton
            text={address}
            label={t("remote.copyWatch")}
            done={t("remote.copied")}
            onRefused={() => setFailed(true)}
          />
        </dd>
      )}
      <dd className={styles["fieldNote"]}>
        <output>{isFailed ? t("remote.watchFailed") : t("remote.watchNote")}</output>
      </dd>
    </>
  );
}

/** The button that was pressed is gone: the one in its place takes the focus over. */
function focusIn(field: HTMLElement | null): void {
  field?.querySelector("button")?.focus();
}
