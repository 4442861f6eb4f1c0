/** Columns and rows of the maze. */
import { MAX_SIDE, resize, sizeOf } from "@corridor/maze";
import { useId, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { joinSentences } from "../../text/joined.ts";
import { setMaze } from "../../model/workspace/workspace-store.ts";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { FieldError } from "../../ui/FieldError.tsx";
import { NumberInput } from "../../ui/NumberInput.tsx";
import { readNumber } from "../../ui/number-text.ts";
import { showUndoable } from "../../model/workspace/show-undoable.ts";
import styles from "./tool-strip.module.css";

interface ResizeDialogProps {
  isOpen: boolean;
  onClose: () => void;
}

export function ResizeDialog({ isOpen, onClose }: ResizeDialogProps) {
  const { workspace, screen } = useServices();
  const { t, i18n } = useTranslation();
  const maze = useStore(workspace, (state) => state.maze);
  return (
    <Dialog isOpen={isOpen} onClose={onClose} title={t("stage.resizeTitle")} width="narrow">
      <SizeForm
        before={sizeOf(maze)}
        onDone={(columns, rows) => {
          const edit = resize(maze, columns, rows);
          onClose();
          if (!edit.ok) return;
          setMaze(workspace, edit.maze);
          const lost = maze.goals.length - edit.maze.goals.length;
          const effects = [
            ...(edit.maze.start === maze.start ? [] : [t("stage.startMoved")]),
            ...(lost === 0 ? [] : [t("stage.goalsOutside", { count: lost })]),
          ];
          if (effects.length > 0)
            showUndoable({ screen, workspace }, i18n, joinSentences(t, effects));
        }}
      />
    </Dialog>
  );
}

interface SizeFormProps {
  before: ReturnType<typeof sizeOf>;
  onDone: (columns: number, rows: number) => void;
}

/** Mounted only while the dialog is open, so that the form starts with the current size. */
function SizeForm({ before, onDone }: SizeFormProps) {
  const { t } = useTranslation();
  const [columns, setColumns] = useState(String(before.columns));
  const [rows, setRows] = useState(String(before.rows));
  return (
    <form
      noValidate
      className={styles["size"]}
      onSubmit={(event) => {
        event.preventDefault();
        const size = [readSide(columns), readSide(rows)] as const;
        if (size[0] !== null && size[1] !== null) onDone(size[0], size[1]);
        else event.currentTarget.querySelector<HTMLElement>('[aria-invalid="true"]')?.focus();
      }}
    >
      <p>{t("stage.resizeText")}</p>
      <div className={styles["sides"]}>
        <SideField label={t("stage.columns")} text={columns} onChange={setColumns} />
        <SideField label={t("stage.rows")} text={rows} onChange={setRows} />
      </div>
      <Button kind="primary" type="submit" className={styles["done"]}>
        {t("stage.resizeDone")}
      </Button>
    </form>
  );
}

interface SideFieldProps {
  label: string;
  text: string;
  onChange: (text: string) => void;
}

/** Retains the typed text on blur: only the button resizes the maze. */
function SideField({ label, text, onChange }: SideFieldProps) {
  const { t } = useTranslation();
  const id = useId();
  const isInvalid = readSide(text) === null;
  return (
    <div className={styles["side"]}>
      <label htmlFor={id}>{label}</label>
      <NumberInput
        id={id}
        draft={{ text, isInvalid, type: onChange, leave: () => undefined }}
        errorId={`${id}-error`}
      />
      {isInvalid && (
        <FieldError id={`${id}-error`}>{t("stage.sideError", { most: MAX_SIDE })}</FieldError>
      )}
    </div>
  );
}

/** Columns or rows as typed; null if a maze cannot have that many. */
function readSide(text: string): number | null {
  return readNumber(text, { min: 1, max: MAX_SIDE, whole: true });
}
