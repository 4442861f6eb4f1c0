/** Opens the share dialog. The only primary button of the top bar. */
import { Share } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { ShareDialog } from "./lazy-share-dialog.ts";
import styles from "./share.module.css";

export function ShareButton() {
  const { t } = useTranslation();
  const [isOpen, setOpen] = useState(false);
  return (
    <>
      <Button
        kind="primary"
        className={styles["trigger"]}
        icon={<Icon of={Share} />}
        aria-haspopup="dialog"
        onClick={() => setOpen(true)}
      >
        <span className={styles["triggerWord"]}>{t("share.share")}</span>
      </Button>
      <ShareDialog isOpen={isOpen} onClose={() => setOpen(false)} />
    </>
  );
}
