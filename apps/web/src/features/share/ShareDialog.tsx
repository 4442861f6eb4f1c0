/** The share dialog: a link that carries the maze itself, and its QR code. */
import { encodeLink } from "@corridor/link";
import { sizeOf } from "@corridor/maze";
import { Info } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Checkbox } from "../../ui/Checkbox.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { sharedSearch } from "../../app/language.ts";
import { LinkField } from "./LinkField.tsx";
import { QrCard } from "./QrCard.tsx";
import styles from "./share.module.css";

interface ShareDialogProps {
  isOpen: boolean;
  onClose: () => void;
}

export function ShareDialog({ isOpen, onClose }: ShareDialogProps) {
  const { t } = useTranslation();
  return (
    <Dialog
      isOpen={isOpen}
      onClose={onClose}
      title={t("share.title")}
      subtitle={t("share.subtitle")}
      footer={
        <p className={styles["privacy"]}>
          <Info size={16} aria-hidden="true" />
          {t("share.private")}
        </p>
      }
    >
      <ShareForm />
    </Dialog>
  );
}

function ShareForm() {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const maze = useStore(workspace, (state) => state.maze);
  const program = useStore(workspace, (state) => state.program);
  const [withProgram, setWithProgram] = useState(false);
  const result = encodeLink(withProgram ? { maze, program } : { maze });
  const { origin, pathname, search } = location;
  const link = result.ok ? `${origin}${pathname}${sharedSearch(search)}#${result.text}` : null;
  return (
    <div className={styles["columns"]}>
      <div className={styles["main"]}>
        <LinkField link={link} />
        <fieldset className={styles["choices"]}>
          <legend className={styles["label"]}>{t("share.carries")}</legend>
          <Checkbox
            label={t("share.maze")}
            note={t("share.mazeNote", { ...sizeOf(maze), count: maze.goals.length })}
            checked
            disabled
            onChange={() => undefined}
          />
          <Checkbox
            label={t("share.program")}
            note={t("share.programNote")}
            checked={withProgram}
            onChange={setWithProgram}
          />
        </fieldset>
      </div>
      {link !== null && <QrCard link={link} name={maze.name} />}
    </div>
  );
}
