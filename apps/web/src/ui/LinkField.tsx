/** The link in a field that selects itself, and the button that copies it. */
import { useId, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { FieldError } from "./FieldError.tsx";
import { CopyButton } from "./CopyButton.tsx";
import styles from "./link-field.module.css";

interface LinkFieldProps {
  /** null if the content is too large for a link */
  link: string | null;
  /** text for that case */
  tooBig: string;
}

export function LinkField({ link, tooBig }: LinkFieldProps) {
  const { t } = useTranslation();
  const id = useId();
  const field = useRef<HTMLInputElement>(null);
  const [isByHand, setByHand] = useState(false);
  if (link === null) {
    return <FieldError id={id}>{tooBig}</FieldError>;
  }
  return (
    <div className={styles["stack"]}>
      <label className={styles["label"]} htmlFor={id}>
        {t("share.link")}
      </label>
      <div className={styles["row"]}>
        <input
          id={id}
          ref={field}
          dir="ltr"
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
