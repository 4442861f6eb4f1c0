/** Shares a lesson: once its teacher has solved it, or wants to share it anyway. */
import { parseLesson, type LessonDocument } from "@corridor/challenge";
import { Info } from "lucide";
import { useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { Button } from "../../../ui/Button.tsx";
import { Dialog } from "../../../ui/Dialog.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { ShareOptions } from "./ShareOptions.tsx";
import styles from "./share-lesson-dialog.module.css";

export interface ShareLessonDialogProps {
  isOpen: boolean;
  lesson: LessonDocument;
  /** whether the teacher solved every task */
  isSolved: boolean;
  /** localStorage */
  device: KeyValueStorage;
  onSolve: () => void;
  onClose: () => void;
}

export function ShareLessonDialog({
  isOpen,
  lesson,
  isSolved,
  device,
  onSolve,
  onClose,
}: ShareLessonDialogProps) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const [isAnyway, setAnyway] = useState(false);
  const content = useRef<HTMLDivElement>(null);
  const isFinished = isOpen && parseLesson(lesson).ok;
  const isShared = isFinished && (isSolved || isAnyway);
  const options = {
    width: "wide" as const,
    subtitle: t("share.subtitle"),
    footer: (
      <p className={styles["private"]}>
        <Icon of={Info} size={16} />
        {t("share.private")}
      </p>
    ),
  };
  return (
    <Dialog
      isOpen={isOpen}
      onClose={() => {
        setAnyway(false);
        onClose();
      }}
      title={t("share.title")}
      width="narrow"
      {...(isShared ? options : {})}
    >
      <div ref={content} className={styles["content"]} tabIndex={-1}>
        {lesson.name.trim() === "" && <p>{t("warnings.unnamed")}</p>}
        {!isFinished && <p>{t("share.unfinished")}</p>}
        {isFinished && !isShared && (
          <>
            <p>{t("share.unsolved")}</p>
            <div className={styles["answers"]}>
              <Button kind="primary" onClick={onSolve}>
                {t("solve.start")}
              </Button>
              <Button
                onClick={() => {
                  setAnyway(true);
                  // The button is gone.
                  content.current?.focus();
                }}
              >
                {t("share.anyway")}
              </Button>
            </div>
          </>
        )}
        {isShared && <ShareOptions lesson={lesson} device={device} />}
      </div>
    </Dialog>
  );
}
