/**
 * The address of the robot, which is all that a script needs. Its key is copied, but not displayed.
 */
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { joinSentences } from "../../text/joined.ts";
import { CopyButton } from "../../ui/CopyButton.tsx";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { useMinutesLeft } from "./use-minutes-left.ts";
import type { RobotAddress } from "../../model/remote/robot-address.ts";
import field from "../../ui/field.module.css";
import styles from "./fields.module.css";

interface AddressFieldProps {
  address: RobotAddress;
  session: RemoteSession;
}

export function AddressField({ address, session }: AddressFieldProps) {
  const { t } = useTranslation();
  const [isRefused, setRefused] = useState(false);
  const timeLeft = useTimeText(useMinutesLeft(session));
  return (
    <dl className={styles["fields"]}>
      <dt className={field["label"]}>{t("remote.address")}</dt>
      <dd className={styles["value"]}>
        <span dir="ltr" className={styles["text"]}>
          {/* Where the browser refuses to copy, the user needs the whole address to select it. */}
          {isRefused ? address.full : address.shown}
        </span>
        <CopyButton
          text={address.full}
          label={t("remote.copyAddress")}
          done={t("remote.copied")}
          onRefused={() => setRefused(true)}
        />
      </dd>
      <dd className={styles["fieldNote"]}>
        <p>
          <output>{isRefused && t("remote.copyByHand")}</output>
          {joinSentences(
            t,
            [isRefused ? "" : t("remote.keepPrivate"), timeLeft].filter((text) => text !== ""),
          )}
        </p>
      </dd>
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
