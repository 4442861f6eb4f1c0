/** Saves the maze as a file of contests, or shows why a format cannot store it. */
import { contestFormats, sizeOf, writeContestMaze } from "@corridor/maze";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../../model/use-services.ts";
import { Button } from "../../../ui/Button.tsx";
import { Dialog } from "../../../ui/Dialog.tsx";
import { fileName } from "../../../ui/file-name.ts";
import { saveFile } from "../../../ui/save-file.ts";
import styles from "./contest-dialog.module.css";

interface ContestDialogProps {
  isOpen: boolean;
  onClose: () => void;
}

export function ContestDialog({ isOpen, onClose }: ContestDialogProps) {
  const { t } = useTranslation("contest", { useSuspense: false });
  return (
    <Dialog
      isOpen={isOpen}
      onClose={onClose}
      title={t("save.title")}
      subtitle={t("save.subtitle")}
      width="narrow"
    >
      <Formats onSaved={onClose} />
    </Dialog>
  );
}

/** Mounted only while the dialog is open, so that each opening writes the newest maze. */
function Formats({ onSaved }: { onSaved: () => void }) {
  const { t } = useTranslation("contest", { useSuspense: false });
  const { workspace } = useServices();
  const maze = useStore(workspace, (state) => state.maze);
  const { columns, rows } = sizeOf(maze);
  const cells = { columns: (columns - 1) / 2, rows: (rows - 1) / 2 };
  return (
    <ul className={styles["formats"]}>
      {contestFormats.map((format) => {
        const written = writeContestMaze(maze, format);
        return (
          <li key={format} className={styles["format"]}>
            <Button
              disabled={!written.ok}
              aria-describedby={`contest-${format}`}
              onClick={() => {
                if (!written.ok) return;
                saveFile(new Blob([written.value]), `${fileName(maze.name, "maze")}.${format}`);
                onSaved();
              }}
            >
              {t(`save.${format}`)}
            </Button>
            <p id={`contest-${format}`} className={styles["note"]}>
              {written.ok ? t(`save.${format}Note`) : t(`refused.${written.refusal.code}`, cells)}
            </p>
          </li>
        );
      })}
    </ul>
  );
}
