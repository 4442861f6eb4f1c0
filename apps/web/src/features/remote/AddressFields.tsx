/** The robot's address and its key, to copy; the key stays hidden until it is asked for. */
import { Eye, EyeOff } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { IconButton } from "../../ui/Button.tsx";
import { CopyButton } from "../share/CopyButton.tsx";
import { maskKey, type RobotAddress } from "./robot-address.ts";
import styles from "./remote.module.css";

export function AddressFields({ address }: { address: RobotAddress }) {
  const { t } = useTranslation();
  const [isKeyShown, setKeyShown] = useState(false);
  const [isRefused, setRefused] = useState(false);
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
        <output>{isRefused ? t("remote.copyByHand") : t("remote.keepPrivate")}</output>
      </dd>
    </dl>
  );
}
