/** Shares a lesson: its link, or its file if it is too long for a link. */
import {
  MAX_CHALLENGE_TEXT_LENGTH,
  oldestDocumentOf,
  parseLesson,
  type LessonDocument,
} from "@corridor/challenge";
import { encodeLink, MAX_LINK_LENGTH } from "@corridor/link";
import { FileDown } from "lucide";
import { useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../../ui/Button.tsx";
import { CopyButton } from "../../../ui/CopyButton.tsx";
import { Dialog } from "../../../ui/Dialog.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { saveDocument } from "../../../ui/save-file.ts";
import { TextField } from "../../../ui/TextField.tsx";
import styles from "./share-lesson-dialog.module.css";

interface ShareLessonDialogProps {
  lesson: LessonDocument;
  /** whether the teacher solved every task */
  isSolved: boolean;
  onSolve: () => void;
  onClose: () => void;
}

export function ShareLessonDialog({ lesson, isSolved, onSolve, onClose }: ShareLessonDialogProps) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  return (
    <Dialog isOpen onClose={onClose} title={t("share.title")} width="narrow">
      <div className={styles["content"]}>
        {parseLesson(lesson).ok ? (
          <SharedLesson lesson={lesson} isSolved={isSolved} onSolve={onSolve} />
        ) : (
          <p>{t("share.unfinished")}</p>
        )}
      </div>
    </Dialog>
  );
}

function SharedLesson({
  lesson,
  isSolved,
  onSolve,
}: Pick<ShareLessonDialogProps, "lesson" | "isSolved" | "onSolve">) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const [isAnyway, setAnyway] = useState(isSolved);
  const field = useRef<HTMLDivElement>(null);
  if (!isAnyway) {
    return (
      <>
        <p>{t("share.unsolved")}</p>
        <div className={styles["answers"]}>
          <Button kind="primary" onClick={onSolve}>
            {t("solve.start")}
          </Button>
          <Button onClick={() => setAnyway(true)}>{t("share.anyway")}</Button>
        </div>
      </>
    );
  }
  const link = encodeLink({ lesson });
  const document = oldestDocumentOf(lesson);
  const isTooLarge = JSON.stringify(document, null, 2).length >= MAX_CHALLENGE_TEXT_LENGTH;
  return (
    <>
      {link.ok ? (
        <div ref={field} className={styles["link"]}>
          <TextField
            label={t("share.link")}
            value={`${location.origin}/#${link.text}`}
            onChange={() => undefined}
            readOnly
            dir="ltr"
          />
          <CopyButton
            kind="primary"
            text={`${location.origin}/#${link.text}`}
            label={t("share.copy")}
            done={t("share.copied")}
            onRefused={() => field.current?.querySelector("input")?.select()}
          />
        </div>
      ) : (
        <p>{t("share.tooLong", { most: MAX_LINK_LENGTH })}</p>
      )}
      {isTooLarge ? (
        <p>{t("share.tooLarge")}</p>
      ) : (
        <Button
          className={styles["file"]}
          icon={<Icon of={FileDown} />}
          onClick={() => saveDocument(document, "lesson")}
        >
          {t("share.file")}
        </Button>
      )}
    </>
  );
}
