/** Clear maze, the one edit that asks first. */
import { clearBlocks } from "@corridor/maze";
import { useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../app/services.ts";
import { setMaze } from "../../stores/workspace-store.ts";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import styles from "./tool-strip.module.css";

export function ClearMaze({ icon }: { icon: ReactNode }) {
  const { workspace, simulator } = useServices();
  const { t } = useTranslation();
  const [isOpen, setOpen] = useState(false);
  function clear(): void {
    setMaze(workspace, clearBlocks(workspace.getState().maze));
    simulator.send({ type: "reset" });
    setOpen(false);
  }
  return (
    <>
      <Button kind="quiet" size="small" icon={icon} onClick={() => setOpen(true)}>
        <span className={styles["word"]}>{t("stage.clear")}</span>
      </Button>
      <Dialog
        isOpen={isOpen}
        onClose={() => setOpen(false)}
        title={t("stage.clearTitle")}
        width="narrow"
        footer={
          <>
            <Button onClick={() => setOpen(false)}>{t("stage.keep")}</Button>
            <Button kind="primary" onClick={clear}>
              {t("stage.clear")}
            </Button>
          </>
        }
      >
        <p>{t("stage.clearText")}</p>
      </Dialog>
    </>
  );
}
