/** The robot's address and its key, to copy; the key stays hidden until it is asked for. */
import { Eye, EyeOff } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { IconButton } from "../../ui/Button.tsx";
import { CopyButton } from "../share/CopyButton.tsx";
import type { RemoteSession } from "../../worker/worker-messages.ts";
import { NewKey } from "./NewKey.tsx";
import { PairingField } from "./PairingField.tsx";
import { WatchField } from "./WatchField.tsx";
import { useMinutesLeft } from "./use-minutes-left.ts";
import { maskKey, type RobotAddress } from "./robot-address.ts";
import styles from "./remote.module.css";

interface AddressFieldsProps {
  address: RobotAddress;
  session: RemoteSession;
}

export function AddressFields({ address, session }: AddressFieldsProps) {
  const { t } = useTranslation();
  const [isKeyShown, setKeyShown] = useState(false);
  const [isRefused, setRefused] = useState(false);
  const [newKey, setNewKey] = useState<"made" | "failed" | null>(null);
  const minutesLeft = useMinutesLeft(session);
  const timeLeft = useTimeText(minutesLeft);
  return (
    <dl className={styles["fields"]}>
      <dt className={styles["label"]}>{t("remote.address")}</dt>
      <dd className={styles["value"]}>
        <span dir="ltr" className={styles["mono"]}>
          {address.shown}
        </span>
        <CopyButton
          text={address.full}
          label={t("remote.copyAddress")}
          done={t("remote.copied")}
          onRefused={() => setRefused(true)}
        />
      </dd>
      <dt className={styles["label"]}>{t("remote.key")}</dt>
      <dd className={styles["value"]}>
        <span dir="ltr" className={styles["mono"]}>
          {isKeyShown ? address.key : maskKey(address.key)}
        </span>
        <IconButton
          label={isKeyShown ? t("remote.hideKey") : t("remote.showKey")}
          onClick={() => setKeyShown(!isKeyShown)}
        >
          {isKeyShown ? <EyeOff aria-hidden="true" /> : <Eye aria-hidden="true" />}
        </IconButton>
        <CopyButton
          text={address.key}
          label={t("remote.copyKey")}
          done={t("remote.copied")}
          onRefused={() => {
            setKeyShown(true);
            setRefused(true);
          }}
        />
      </dd>
      <dd className={styles["fieldNote"]}>
        <p>
          <output>
            {isRefused && t("remote.copyByHand")}
            {!isRefused && newKey === "made" && t("remote.newKeyMade")}
            {!isRefused && newKey === "failed" && t("remote.newKeyFailed")}
          </output>
          {!isRefused && newKey === null && t("remote.keepPrivate")} {timeLeft}
        </p>
        <NewKey
          session={session}
          onDone={(isMade) => {
            setNewKey(isMade ? "made" : "failed");
            setKeyShown(false);
          }}
        />
      </dd>
      <PairingField session={session} />
      <WatchField session={session} />
    </dl>
  );
}

function useTimeText(minutesLeft: number | null): string {
  const { t } = useTranslation();
  if (minutesLeft === null) return "";
  const [hours, minutes] = [Math.floor(minutesLeft / 60), minutesLeft % 60];
  return hours > 0
    ? t("remote.endsInHours", { hours, minutes })
    : t("remote.endsInMinutes", { minutes });
}
