/** Saves a picture of the maze, with or without the run of the robot. */
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import { Button } from "../../ui/Button.tsx";
import { Checkbox } from "../../ui/Checkbox.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { FieldError } from "../../ui/FieldError.tsx";
import { fileName } from "../../ui/file-name.ts";
import { pngOf, type Picture } from "../../stage/svg/picture.ts";
import { drawPicture } from "./draw-picture.ts";
import { saveFile } from "../../ui/save-file.ts";
import styles from "./picture-dialog.module.css";

interface PictureDialogProps {
  isOpen: boolean;
  onClose: () => void;
}

export function PictureDialog({ isOpen, onClose }: PictureDialogProps) {
  const { t } = useTranslation();
  return (
    <Dialog
      isOpen={isOpen}
      onClose={onClose}
      title={t("files.picture.title")}
      subtitle={t("files.picture.subtitle")}
      width="narrow"
      footer={t("files.picture.formats")}
    >
      <PictureForm onSaved={onClose} />
    </Dialog>
  );
}

/** Mounted only while the dialog is open, so that each opening draws a new picture. */
function PictureForm({ onSaved }: { onSaved: () => void }) {
  const { t } = useTranslation();
  const services = useServices();
  const words = { startWord: t("stage.startWord"), goalWord: t("stage.goalWord") };
  const draw = (withRun: boolean, hasRulers: boolean): Picture =>
    drawPicture(services, words, { withRun, hasRulers });
  const [choice, setChoice] = useState({ withRun: true, hasRulers: true });
  const [picture, setPicture] = useState(() => draw(true, true));
  const [hasFailed, setHasFailed] = useState(false);
  const { name } = services.workspace.getState().maze;

  function change(next: typeof choice): void {
    setChoice(next);
    setPicture(draw(next.withRun, next.hasRulers));
  }

  function save(content: Blob, ending: string): void {
    saveFile(content, `${fileName(name, "maze")}.${ending}`);
    onSaved();
  }

  return (
    <div className={styles["form"]}>
      <img
        className={styles["preview"]}
        src={`data:image/svg+xml;charset=utf-8,${encodeURIComponent(picture.svg)}`}
        width={picture.width}
        height={picture.height}
        alt={t("files.picture.preview", { name: name === "" ? t("projects.unnamed") : name })}
      />
      <div className={styles["choices"]}>
        <Checkbox
          label={t("files.picture.trail")}
          checked={choice.withRun}
          onChange={(withRun) => change({ ...choice, withRun })}
        />
        <Checkbox
          label={t("files.picture.rulers")}
          checked={choice.hasRulers}
          onChange={(hasRulers) => change({ ...choice, hasRulers })}
        />
      </div>
      {hasFailed && <FieldError id="picture-error">{t("files.picture.failed")}</FieldError>}
      <div className={styles["buttons"]}>
        <Button onClick={() => save(new Blob([picture.svg], { type: "image/svg+xml" }), "svg")}>
          {t("files.picture.svg")}
        </Button>
        <Button
          kind="primary"
          onClick={() =>
            void pngOf(picture).then(
              (png) => save(png, "png"),
              () => setHasFailed(true),
            )
          }
        >
          {t("files.picture.png")}
        </Button>
      </div>
    </div>
  );
}
