/** Columns and rows of the maze. */
import { MAX_SIDE, resize, sizeOf } from "@corridor/maze";
import { useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../app/services.ts";
import { setMaze } from "../../stores/workspace-store.ts";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { NumberField } from "../../ui/NumberField.tsx";
import styles from "./tool-strip.module.css";

export function ResizeMaze({ icon }: { icon: ReactNode }) {
  const { workspace } = useServices();
  const { t } = useTranslation();
  const [isOpen, setOpen] = useState(false);
  const [columns, setColumns] = useState(1);
  const [rows, setRows] = useState(1);
  function open(): void {
    const size = sizeOf(workspace.getState().maze);
    setColumns(size.columns);
    setRows(size.rows);
    setOpen(true);
  }
  function apply(): void {
    const edit = resize(workspace.getState().maze, columns, rows);
    if (edit.ok) setMaze(workspace, edit.maze);
    setOpen(false);
  }
  return (
    <>
      <Button kind="quiet" size="small" icon={icon} onClick={open}>
        <span className={styles["word"]}>{t("stage.resize")}</span>
      </Button>
      <Dialog
        isOpen={isOpen}
        onClose={() => setOpen(false)}
        title={t("stage.resizeTitle")}
        width="narrow"
        footer={
          <Button kind="primary" onClick={apply}>
            {t("stage.resizeDone")}
          </Button>
        }
      >
        <p>{t("stage.resizeText")}</p>
        <div className={styles["sides"]}>
          <NumberField
            label={t("stage.columns")}
            value={columns}
            onChange={setColumns}
            min={1}
            max={MAX_SIDE}
            errorText={t("stage.sideError", { most: MAX_SIDE })}
          />
          <NumberField
            label={t("stage.rows")}
            value={rows}
            onChange={setRows}
            min={1}
            max={MAX_SIDE}
            errorText={t("stage.sideError", { most: MAX_SIDE })}
          />
        </div>
      </Dialog>
    </>
  );
}
