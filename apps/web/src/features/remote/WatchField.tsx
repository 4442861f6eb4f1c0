/** The watch link for viewers, created on request because most robots need none. */
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { CopyButton } from "../../ui/CopyButton.tsx";
import { createWatchAddress } from "./owner-calls.ts";
import { maskKey } from "../../model/remote/robot-address.ts";
import panel from "./remote.module.css";
import field from "../../ui/field.module.css";
import fields from "./fields.module.css";

export function WatchField({ session }: { session: RemoteSession }) {
  const { t } = useTranslation();
  const [address, setAddress] = useState<string | null>(null);
  const [isFailed, setFailed] = useState(false);
  const make = async (): Promise<void> => {
    const made = await createWatchAddress(fetch, session);
    setAddress(made);
    setFailed(made === null);
  };
  return (
    <>
      <dt className={field["label"]}>{t("remote.watch")}</dt>
      {address === null ? (
        <dd>
          <Button size="small" className={panel["long"]} onClick={() => void make()}>
            {t("remote.makeWatch")}
          </Button>
        </dd>
      ) : (
        <dd className={fields["value"]} ref={focusIn}>
          <span dir="ltr" className={fields["text"]}>
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
      <dd className={fields["fieldNote"]}>
        <output>{isFailed ? t("remote.watchFailed") : t("remote.watchNote")}</output>
      </dd>
    </>
  );
}

/** Moves the focus from the pressed button, which is gone, to the button in its place. */
function focusIn(field: HTMLElement | null): void {
  field?.querySelector("button")?.focus();
}
