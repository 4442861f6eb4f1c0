/** The content of the maze menu: the maze's name, a new maze, and the projects on this device. */
import { FilePlus2 } from "lucide";
import { useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import type { Project } from "../../model/projects/project-storage.ts";
import { Icon } from "../../ui/Icon.tsx";
import { MenuItem } from "../../ui/Popover.tsx";
import { openEmptyMaze } from "./open-empty-maze.ts";
import { RenameField } from "./RenameField.tsx";
import { SaveState } from "./SaveState.tsx";
import { ProjectList } from "./ProjectList.tsx";

interface MazeMenuContentProps {
  /** the items for files */
  files: ReactNode;
  /** closes the menu */
  onDone: () => void;
}

export function MazeMenuContent({ files, onDone }: MazeMenuContentProps) {
  const { t, i18n } = useTranslation();
  const services = useServices();
  const [projects, setProjects] = useState<readonly Project[]>(() => services.projects.list());
  return (
    <>
      <RenameField />
      <MenuItem
        icon={<Icon of={FilePlus2} />}
        note={t("projects.newMazeNote")}
        onSelect={() => openEmptyMaze(services, i18n)}
      >
        {t("projects.newMaze")}
      </MenuItem>
      {files}
      <ProjectList
        projects={projects}
        onOpen={(project) => {
          onDone();
          services.projects.open(project);
        }}
        onDelete={(project) => {
          services.projects.remove(project);
          setProjects(services.projects.list());
        }}
      />
      <SaveState isInMenu />
    </>
  );
}
