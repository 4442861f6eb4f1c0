/** The maze's name, which opens its menu: rename, a new maze, the works on this device. */
import { ChevronDown, FilePlus2 } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import type { Work } from "../../app/works.ts";
import { Button } from "../../ui/Button.tsx";
import { MenuItem, Popover, usePopover } from "../../ui/Popover.tsx";
import { openEmptyMaze } from "./empty-maze.ts";
import { RenameField } from "./RenameField.tsx";
import { SaveState } from "./SaveState.tsx";
import { WorksList } from "./WorksList.tsx";
import styles from "./maze-menu.module.css";

export function MazeMenu() {
  const { t, i18n } = useTranslation();
  const services = useServices();
  const name = useStore(services.workspace, (state) => state.maze.name);
  const menu = usePopover();
  const [works, setWorks] = useState<readonly Work[]>([]);
  const shownName = name === "" ? t("works.unnamed") : name;
  return (
    <div className={styles["menu"]}>
      <Button
        kind="quiet"
        className={styles["trigger"]}
        aria-label={`${shownName}, ${t("works.menu")}`}
        {...menu.trigger}
      >
        <span className={styles["name"]}>{shownName}</span>
        <ChevronDown aria-hidden="true" />
      </Button>
      <SaveState />
      <Popover
        {...menu.panel}
        label={t("works.menu")}
        className={styles["panel"]}
        onOpenChange={(isOpen) => {
          if (isOpen) setWorks(services.works.list());
          menu.panel.onOpenChange(isOpen);
        }}
      >
        <RenameField />
        <MenuItem
          icon={<FilePlus2 aria-hidden="true" />}
          note={t("works.newMazeNote")}
          onSelect={() => openEmptyMaze(services, i18n)}
        >
          {t("works.newMaze")}
        </MenuItem>
        <WorksList
          works={works}
          onOpen={(work) => {
            menu.close();
            services.works.open(work);
          }}
          onDelete={(work) => {
            services.works.remove(work);
            setWorks(services.works.list());
          }}
        />
        <SaveState isInMenu />
      </Popover>
    </div>
  );
}
