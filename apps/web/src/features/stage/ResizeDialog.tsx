/** Columns and rows of the maze. */
import { MAX_SIDE, resize, sizeOf } from "@corridor/maze";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../app/services.ts";
import { setMaze } from "../../stores/workspace-store.ts";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { NumberField } from "../../ui/NumberField.tsx";
import styles from "./tool-strip.module.css";

interface ResizeDialogProps {
  isOpen: boolean;
  onClose: () => void;
}

export function ResizeDialog({ isOpen, onClose }: ResizeDialogProps) {
  const { workspace } = useServices();
  const { t } = useTranslation();
  return (
    <Dialog isOpen={isOpen} onClose={onClose} title={t("stage.resizeTitle")} width="narrow">
      <SizeForm
        before={sizeOf(workspace.getState().maze)}
        onDone={(columns, rows) => {
          const edit = resize(workspace.getState().maze, columns, rows);
          if (edit.ok) setMaze(workspace, edit.maze);
          onClose();
        }}
      />
    </Dialog>
  );
}

interface SizeFormProps {
  before: ReturnType<typeof sizeOf>;
  onDone: (columns: number, rows: number) => void;
}

/** Lives only while the dialog is open, so it begins with the size that the maze has then. */
function SizeForm({ before, onDone }: SizeFormProps) {
  const { t } = useTranslation();
  const [columns, setColumns] = useState(before.columns);
  const [rows, setRows] = useState(before.rows);
  const sides = [
    { label: t("stage.columns"), value: columns, onChange: setColumns },
    { label: t("stage.rows"), value: rows, onChange: setRows },
  ];
  return (
    <form
      noValidate
      className={styles["size"]}
      onSubmit={(event) => {
        event.preventDefault();
        onDone(columns, rows);
      }}
    >
      <p>{t("stage.resizeText")}</p>
      <div className={styles["sides"]}>
        {sides.map((side) => (
          <NumberField
            key={side.label}
            {...side}
            min={1}
            max={MAX_SIDE}
            errorText={t("stage.sideError", { most: MAX_SIDE })}
          />
        ))}
      </div>
      <Button kind="primary" type="submit" className={styles["done"]}>
        {t("stage.resizeDone")}
      </Button>
    </form>
  );
}
