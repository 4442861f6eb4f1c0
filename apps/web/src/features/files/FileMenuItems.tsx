/** The menu items that open and save files. */
import type { LessonDocument } from "@corridor/challenge";
import { FileBraces, FileInput, FileText, Film, GraduationCap, Image, ListOrdered } from "lucide";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { showMessage } from "../../model/screen/screen-store.ts";
import { useTool } from "../../model/use-rights.ts";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { MenuItem } from "../../ui/Popover.tsx";
import { useFileActions } from "./file-actions.ts";
import { saveDocument, saveTextMaze } from "../../ui/save-file.ts";
import { ContestMenuItem } from "./contest/ContestMenuItem.tsx";
import { saveRun } from "./save-run.ts";

/** @param race the item that races the run, below the one that saves it */
export function FileMenuItems({ race }: { race: ReactNode }) {
  const { t, i18n } = useTranslation();
  const services = useServices();
  const { workspace } = services;
  const hasRun = useStore(services.run, ({ nowTick }) => nowTick > 0);
  const { choose, savePicture, saveContest } = useFileActions();
  const lesson = useStore(services.challenge, (state) => state.lesson);
  const hasFiles = useTool("files");
  if (!hasFiles) return race;

  async function saveLesson(document: LessonDocument): Promise<void> {
    try {
      (await import("./save-lesson.ts")).saveLesson(document);
    } catch {
      showMessage(services.screen, { tone: "bad", text: t("offline.partFailed") });
    }
  }

  return (
    <>
      <MenuItem icon={<Icon of={FileInput} />} note={t("files.openNote")} onSelect={choose}>
        {t("files.open")}
      </MenuItem>
      <MenuItem
        icon={<Icon of={FileBraces} />}
        onSelect={() => saveDocument(workspace.getState().maze, "maze")}
      >
        {t("files.saveMaze")}
      </MenuItem>
      <MenuItem
        icon={<Icon of={FileText} />}
        onSelect={() => saveTextMaze(workspace.getState().maze)}
      >
        {t("files.saveText")}
      </MenuItem>
      <ContestMenuItem onSelect={saveContest} />
      <MenuItem
        icon={<Icon of={ListOrdered} isDirectional />}
        onSelect={() => saveDocument(workspace.getState().program, "program")}
      >
        {t("files.saveProgram")}
      </MenuItem>
      <MenuItem
        icon={<Icon of={Film} />}
        disabled={!hasRun}
        onSelect={() => saveRun(services, i18n)}
      >
        {t("files.saveRun")}
      </MenuItem>
      {lesson !== null && (
        <MenuItem icon={<Icon of={GraduationCap} />} onSelect={() => void saveLesson(lesson)}>
          {i18n.t("missions:lesson.save")}
        </MenuItem>
      )}
      {race}
      <MenuItem icon={<Icon of={Image} />} onSelect={savePicture}>
        {t("files.savePicture")}
      </MenuItem>
    </>
  );
}
