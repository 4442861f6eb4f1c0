/** Opens the share dialog. The only primary button of the top bar. */
import { Share } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { ShareDialog } from "./lazy-share-dialog.ts";
import styles from "./share.module.css";

export function ShareButton() {
  const { t } = useTranslation();
  const { screen } = useServices();
  const isOpen = useStore(screen, (state) => state.isSharing);
  return (
    <>
      <Button
        kind="primary"
        className={styles["trigger"]}
        icon={<Icon of={Share} />}
        aria-haspopup="dialog"
        onClick={() => screen.setState({ isSharing: true })}
      >
        <span className={styles["triggerWord"]}>{t("share.share")}</span>
      </Button>
      <ShareDialog isOpen={isOpen} onClose={() => screen.setState({ isSharing: false })} />
    </>
  );
}
