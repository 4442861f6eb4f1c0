/** The maze's name as a field. All changes until the field loses focus are one step of undo. */
import { MAX_NAME_LENGTH, rename } from "@corridor/maze";
import { useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { beginStroke, setMaze } from "../../model/workspace/workspace-store.ts";
import { TextField } from "../../ui/TextField.tsx";
import styles from "./maze-menu.module.css";

export function RenameField() {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const name = useStore(workspace, (state) => state.maze.name);
  const endStroke = useRef<(() => void) | null>(null);
  const end = (): void => {
    endStroke.current?.();
    endStroke.current = null;
  };
  // Closing the menu removes the field without a blur event.
  useEffect(() => () => endStroke.current?.(), []);
  return (
    <div className={styles["rename"]}>
      <TextField
        label={t("projects.name")}
        value={name}
        maxLength={MAX_NAME_LENGTH}
        onFocus={() => (endStroke.current ??= beginStroke(workspace))}
        onBlur={end}
        onKeyDown={(event) => {
          if (event.key === "Enter") {
            // The focus moves to the menu's button, which the same key would press again.
            event.preventDefault();
            event.currentTarget.closest<HTMLElement>("[popover]")?.hidePopover();
          }
        }}
        onChange={(text) => {
          const edit = rename(workspace.getState().maze, text);
          if (edit.ok) setMaze(workspace, edit.maze);
        }}
      />
    </div>
  );
}
