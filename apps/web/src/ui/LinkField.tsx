/** The link in a field that selects itself, and the button that copies it. */
import { useId } from "react";
import { useTranslation } from "react-i18next";
import { CopyField } from "./CopyField.tsx";
import { FieldError } from "./FieldError.tsx";

interface LinkFieldProps {
  /** null if the content is too large for a link */
  link: string | null;
  /** text for that case */
  tooBig: string;
}

export function LinkField({ link, tooBig }: LinkFieldProps) {
  const { t } = useTranslation();
  const id = useId();
  if (link === null) return <FieldError id={id}>{tooBig}</FieldError>;
  return (
    <CopyField
      look="link"
      label={t("share.link")}
      text={link}
      copy={t("share.copy")}
      copied={t("share.copied")}
      byHand={t("share.copyByHand")}
    />
  );
}
