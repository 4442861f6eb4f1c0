/** The menu items that open and save files. */
import { FileBraces, FileInput, FileText, Film, Image, ListOrdered } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { MenuItem } from "../../ui/Popover.tsx";
import { RaceMenuItem } from "../race/RaceButton.tsx";
import { useFileActions } from "./file-actions.ts";
import { saveDocument, saveTextMaze } from "./save-file.ts";
import { saveRun } from "./save-run.ts";

export function FileMenuItems() {
  const { t, i18n } = useTranslation();
  const services = useServices();
  const { workspace } = services;
  const hasRun = useStore(services.run, ({ nowTick }) => nowTick > 0);
  const { choose, savePicture } = useFileActions();
  return (
    <>
      <MenuItem
        icon={<FileInput aria-hidden="true" />}
        note={t("files.openNote")}
        onSelect={choose}
      >
        {t("files.open")}
      </MenuItem>
      <MenuItem
        icon={<FileBraces aria-hidden="true" />}
        onSelect={() => saveDocument(workspace.getState().maze, "maze")}
      >
        {t("files.saveMaze")}
      </MenuItem>
      <MenuItem
        icon={<FileText aria-hidden="true" />}
        onSelect={() => saveTextMaze(workspace.getState().maze)}
      >
        {t("files.saveText")}
      </MenuItem>
      <MenuItem
        icon={<ListOrdered aria-hidden="true" />}
        onSelect={() => saveDocument(workspace.getState().program, "program")}
      >
        {t("files.saveProgram")}
      </MenuItem>
      <MenuItem
        icon={<Film aria-hidden="true" />}
        disabled={!hasRun}
        onSelect={() => saveRun(services, i18n)}
      >
        {t("files.saveRun")}
      </MenuItem>
      <RaceMenuItem />
      <MenuItem icon={<Image aria-hidden="true" />} onSelect={savePicture}>
        {t("files.savePicture")}
      </MenuItem>
    </>
  );
}
