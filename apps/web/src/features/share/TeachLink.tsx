/** Opens the pages for teachers with what is shared. */
import { useTranslation } from "react-i18next";
import styles from "./teach-link.module.css";

/** @param text the link without its address: the part after the `#` */
export function TeachLink({ text }: { text: string }) {
  const { t } = useTranslation();
  return (
    <a className={styles["link"]} href={`/teach#${text}`}>
      {t("share.teach")}
    </a>
  );
}
