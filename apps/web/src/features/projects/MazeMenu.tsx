/** The maze's name, which opens its menu. */
import { ChevronDown } from "lucide";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { joinList } from "../../text/joined.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { lazyPart } from "../../ui/lazy-part.tsx";
import { Popover, usePopover } from "../../ui/Popover.tsx";
import { SaveState } from "./SaveState.tsx";
import styles from "./maze-menu.module.css";

const MazeMenuContent = lazyPart(
  async () => (await import("./MazeMenuContent.tsx")).MazeMenuContent,
);

/** @param files the items for files in the menu */
export function MazeMenu({ files }: { files: ReactNode }) {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const name = useStore(workspace, (state) => state.maze.name);
  const menu = usePopover();
  const shownName = name === "" ? t("projects.unnamed") : name;
  return (
    <div className={styles["menu"]}>
      <Button
        kind="quiet"
        className={styles["trigger"]}
        aria-label={joinList(t, [shownName, t("projects.menu")])}
        {...menu.trigger}
      >
        <span className={styles["name"]}>{shownName}</span>
        <Icon of={ChevronDown} />
      </Button>
      <SaveState />
      <Popover {...menu.panel} label={t("projects.menu")} className={styles["panel"]}>
        <MazeMenuContent files={files} onDone={menu.close} />
      </Popover>
    </div>
  );
}
