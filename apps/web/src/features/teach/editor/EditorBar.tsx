/** The bar of the editor: the lesson and whether it is saved, the history, Try and Share. */
import { Ellipsis, ListChecks, Play, Redo2, Rows3, Share2, Undo2, Users } from "lucide";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Button, IconButton } from "../../../ui/Button.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { MenuItem, Popover, usePopover } from "../../../ui/Popover.tsx";
import type { LessonAutosave } from "./lesson-autosave.ts";
import { lessonName } from "../../../model/lessons/lesson-name.ts";
import { handInsHash } from "../frame/teach-view.ts";
import { useDraft, useLesson } from "./draft-context.ts";
import styles from "./editor-bar.module.css";

export function EditorBar({ autosave }: { autosave: LessonAutosave }) {
  const { t } = useTranslation(["lessonEditor", "teach"], { useSuspense: false });
  const lesson = useLesson();
  const status = useStore(autosave.store, (state) => state.status);
  const isFork = useStore(autosave.store, (state) => state.isFork);
  return (
    <div className={styles["lesson"]}>
      <h2 className={styles["name"]} lang={lesson.language ?? undefined} dir="auto">
        {lessonName(lesson) || t("teach:lesson.unnamed")}
      </h2>
      <span className={styles["status"]} data-status={status}>
        {t(`lessonEditor:status.${status}`)}
      </span>
      <span role="alert" className={styles["note"]}>
        {status === "blocked" && t("lessonEditor:blocked")}
      </span>
      <output className={styles["note"]}>{isFork && t("lessonEditor:forked")}</output>
    </div>
  );
}

interface EditorBarEndProps {
  isPhone: boolean;
  autosave: LessonAutosave;
  tools: ReactNode;
  onTry: () => void;
  onStart: () => void;
  onShare: () => void;
}

export function EditorBarEnd(props: EditorBarEndProps) {
  const { isPhone, autosave, tools, onTry, onStart, onShare } = props;
  const { t } = useTranslation(["lessonEditor", "teach"], { useSuspense: false });
  const draft = useDraft();
  const canUndo = useStore(draft.store, ({ past }) => past.length > 0);
  const canRedo = useStore(draft.store, ({ future }) => future.length > 0);
  const id = useStore(autosave.store, (state) => state.id);
  const menu = usePopover();
  return (
    <>
      <div className={styles["history"]}>
        <IconButton label={t("undo")} disabled={!canUndo} onClick={() => draft.undo()}>
          <Icon of={Undo2} isDirectional />
        </IconButton>
        <IconButton label={t("redo")} disabled={!canRedo} onClick={() => draft.redo()}>
          <Icon of={Redo2} isDirectional />
        </IconButton>
      </div>
      {!isPhone && (
        <>
          <Button icon={<Icon of={Play} />} onClick={onTry}>
            {t("try.start")}
          </Button>
          <Button icon={<Icon of={Users} />} onClick={onStart}>
            {t("teach:class.start")}
          </Button>
          <Button kind="primary" icon={<Icon of={Share2} />} onClick={onShare}>
            {t("share.title")}
          </Button>
        </>
      )}
      <IconButton label={t("menu.label")} size="medium" {...menu.trigger}>
        <Icon of={Ellipsis} />
      </IconButton>
      <Popover {...menu.panel} label={t("menu.label")} align="end">
        {isPhone && (
          <>
            <MenuItem icon={<Icon of={Play} />} onSelect={onTry}>
              {t("try.start")}
            </MenuItem>
            <MenuItem icon={<Icon of={Users} />} onSelect={onStart}>
              {t("teach:class.start")}
            </MenuItem>
            <MenuItem icon={<Icon of={Share2} />} onSelect={onShare}>
              {t("share.title")}
            </MenuItem>
          </>
        )}
        <MenuItem
          icon={<Icon of={ListChecks} />}
          onSelect={() => {
            autosave.flush();
            location.hash = handInsHash(id);
          }}
        >
          {t("menu.handIns")}
        </MenuItem>
        <MenuItem icon={<Icon of={Rows3} />} onSelect={() => (location.hash = "")}>
          {t("menu.all")}
        </MenuItem>
        {isPhone && <div className={styles["tools"]}>{tools}</div>}
      </Popover>
      {!isPhone && <div className={styles["tools"]}>{tools}</div>}
    </>
  );
}
