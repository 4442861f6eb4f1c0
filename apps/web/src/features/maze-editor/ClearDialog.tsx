/** Clear maze, the only edit that asks for confirmation. */
import { clearBlocks } from "@corridor/maze";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import { setMaze } from "../../model/workspace/workspace-store.ts";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import styles from "./tool-strip.module.css";

interface ClearDialogProps {
  isOpen: boolean;
  onClose: () => void;
}

export function ClearDialog({ isOpen, onClose }: ClearDialogProps) {
  const { workspace, simulator } = useServices();
  const { t } = useTranslation();
  function clear(): void {
    setMaze(workspace, clearBlocks(workspace.getState().maze));
    simulator.send({ type: "reset" });
    onClose();
  }
  return (
    <Dialog
      isOpen={isOpen}
      onClose={onClose}
      title={t("stage.clearTitle")}
      width="narrow"
      footer={
        <div className={styles["answers"]}>
          <Button onClick={onClose}>{t("stage.keep")}</Button>
          <Button kind="primary" onClick={clear}>
            {t("stage.clear")}
          </Button>
        </div>
      }
    >
      <p>{t("stage.clearText")}</p>
    </Dialog>
  );
}
