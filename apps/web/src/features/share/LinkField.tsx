/** The link in a field that selects itself, and the button that copies it. */
import { MAX_LINK_LENGTH } from "@corridor/link";
import { useId, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { FieldError } from "../../ui/FieldError.tsx";
import { CopyButton } from "./CopyButton.tsx";
import styles from "./share.module.css";

/** @param link null when the maze is too big for one */
export function LinkField({ link }: { link: string | null }) {
  const { t } = useTranslation();
  const id = useId();
  const field = useRef<HTMLInputElement>(null);
  const [isByHand, setByHand] = useState(false);
  if (link === null) {
    return <FieldError id={id}>{t("share.tooBig", { limit: MAX_LINK_LENGTH })}</FieldError>;
  }
  return (
    <div className={styles["link"]}>
      <label className={styles["label"]} htmlFor={id}>
        {t("share.link")}
      </label>
      <div className={styles["linkRow"]}>
        <input
          id={id}
          ref={field}
          className={styles["address"]}
          readOnly
          value={link}
          onFocus={(event) => event.target.select()}
        />
        <CopyButton
          text={link}
          label={t("share.copy")}
          done={t("share.copied")}
          kind="primary"
          size="large"
          onRefused={() => {
            field.current?.focus();
            field.current?.select();
            setByHand(true);
          }}
        />
      </div>
      <output className={styles["note"]}>{isByHand ? t("share.copyByHand") : ""}</output>
    </div>
  );
}
