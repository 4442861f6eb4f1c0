/**
 * The key in the robot's address, hidden until the user shows it, and the button that replaces it.
 */
import { Eye, EyeOff } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import { IconButton } from "../../ui/Button.tsx";
import { CopyButton } from "../../ui/CopyButton.tsx";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { NewKey } from "./NewKey.tsx";
import { maskKey } from "../../model/remote/robot-address.ts";
import field from "../../ui/field.module.css";
import styles from "./fields.module.css";

export function KeyField({ session }: { session: RemoteSession }) {
  const { t } = useTranslation();
  const [isKeyShown, setKeyShown] = useState(false);
  const [isRefused, setRefused] = useState(false);
  const [newKey, setNewKey] = useState<"made" | "failed" | null>(null);
  const { driverKey: key } = session;
  return (
    <>
      <dt className={field["label"]}>{t("remote.key")}</dt>
      <dd className={styles["value"]}>
        <span dir="ltr" className={styles["text"]}>
          {isKeyShown ? key : maskKey(key)}
        </span>
        <IconButton
          label={isKeyShown ? t("remote.hideKey") : t("remote.showKey")}
          onClick={() => setKeyShown(!isKeyShown)}
        >
          {isKeyShown ? <Icon of={EyeOff} /> : <Icon of={Eye} />}
        </IconButton>
        <CopyButton
          text={key}
          label={t("remote.copyKey")}
          done={t("remote.copied")}
          onRefused={() => {
            setKeyShown(true);
            setRefused(true);
          }}
        />
      </dd>
      <dd className={styles["fieldNote"]}>
        <output>
          {isRefused && t("remote.copyByHand")}
          {!isRefused && newKey === "made" && t("remote.newKeyMade")}
          {!isRefused && newKey === "failed" && t("remote.newKeyFailed")}
        </output>
        <NewKey
          session={session}
          onDone={(isMade) => {
            setNewKey(isMade ? "made" : "failed");
            setKeyShown(false);
          }}
        />
      </dd>
    </>
  );
}
