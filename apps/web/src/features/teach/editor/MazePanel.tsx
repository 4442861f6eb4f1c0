/** The given mazes of the open task as tabs, the stage that edits them, and the unseen mazes. */
import { MAX_CHALLENGE_MAZES } from "@corridor/challenge";
import { mazePresets } from "@corridor/maze";
import { Copy, Plus, SquareDashed, Trash2 } from "lucide";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Button, IconButton } from "../../../ui/Button.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { MenuItem, Popover, usePopover } from "../../../ui/Popover.tsx";
import { Segmented } from "../../../ui/Segmented.tsx";
import { emptyTaskMaze } from "../lessons/new-lesson.ts";
import { useDraft, useOpenTask } from "./draft-context.ts";
import styles from "./maze-panel.module.css";
import { UnseenMazes } from "./UnseenMazes.tsx";

export function MazePanel({ stage }: { stage: ReactNode }) {
  return (
    <div className={styles["panel"]}>
      <MazeTabs />
      <div className={styles["stage"]}>{stage}</div>
      <UnseenMazes />
    </div>
  );
}

function MazeTabs() {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const draft = useDraft();
  const { mazes } = useOpenTask();
  const open = useStore(draft.store, (state) => state.maze);
  return (
    <div className={styles["mazes"]}>
      <Segmented
        look="strip"
        label={t("mazes.label")}
        value={String(open)}
        options={mazes.map((_, at) => ({
          value: String(at),
          label: t("mazes.name", { number: at + 1 }),
        }))}
        onChange={(at) => draft.openMaze(Number(at))}
      />
      <AddMaze isFull={mazes.length >= MAX_CHALLENGE_MAZES} />
      {mazes.length > 1 && (
        <IconButton
          label={t("mazes.remove", { number: open + 1 })}
          onClick={() => draft.removeMaze()}
        >
          <Icon of={Trash2} />
        </IconButton>
      )}
    </div>
  );
}

function AddMaze({ isFull }: { isFull: boolean }) {
  const { t } = useTranslation(["lessonEditor", "teach", "words"], { useSuspense: false });
  const draft = useDraft();
  const menu = usePopover();
  return (
    <>
      <Button
        kind="quiet"
        size="small"
        icon={<Icon of={Plus} />}
        disabled={isFull}
        {...menu.trigger}
      >
        {t("lessonEditor:mazes.add")}
      </Button>
      <Popover {...menu.panel} label={t("lessonEditor:mazes.add")}>
        <MenuItem
          icon={<Icon of={SquareDashed} />}
          onSelect={() => draft.addMaze(emptyTaskMaze(t("teach:make.mazeName")))}
        >
          {t("teach:make.empty.name")}
        </MenuItem>
        <MenuItem
          icon={<Icon of={Copy} />}
          onSelect={() => {
            const { task, store } = draft;
            const maze = task.mazes[store.getState().maze];
            if (maze !== undefined) draft.addMaze(maze);
          }}
        >
          {t("lessonEditor:mazes.copy")}
        </MenuItem>
        {mazePresets.map(({ id, maze }) => {
          const name = t(`words:presets.${id}.title`);
          return (
            <MenuItem key={id} onSelect={() => draft.addMaze({ ...maze, name })}>
              {name}
            </MenuItem>
          );
        })}
      </Popover>
    </>
  );
}
