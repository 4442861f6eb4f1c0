/** Sends a lesson of this device to the class. It opens beside the work of the students. */
import { parseLesson } from "@corridor/challenge";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { lessonName } from "../../model/lessons/lesson-name.ts";
import { storageOrNone } from "../../model/storage/key-value-storage.ts";
import { SavedLessons } from "../../model/teaching/saved-lessons.ts";
import { SharedLessons } from "../../model/teaching/shared-lessons.ts";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { Select } from "../../ui/Select.tsx";
import { useContent } from "./dashboard-context.ts";
import styles from "./dashboard.module.css";

export interface SendLessonProps {
  isOpen: boolean;
  onClose: () => void;
}

export function SendLesson({ isOpen, onClose }: SendLessonProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  return (
    <Dialog isOpen={isOpen} onClose={onClose} title={t("send.title")} width="narrow">
      {isOpen && <SendForm onClose={onClose} />}
    </Dialog>
  );
}

function SendForm({ onClose }: Pick<SendLessonProps, "onClose">) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { calls, report } = useContent();
  const [device] = useState(() => storageOrNone(() => localStorage));
  const [saved] = useState(() =>
    new SavedLessons(device).list().filter(({ lesson }) => parseLesson(lesson).ok),
  );
  const [chosen, setChosen] = useState(saved[0]?.id ?? "");
  const [isSent, setSent] = useState(false);
  const send = async (): Promise<void> => {
    const found = saved.find(({ id }) => id === chosen);
    if (found === undefined) return;
    const refusal = await calls.sendLesson(found.lesson);
    report(refusal);
    if (refusal !== null) {
      onClose();
      return;
    }
    new SharedLessons(device).add(found.lesson);
    setSent(true);
  };
  if (saved.length === 0) return <p>{t("send.none")}</p>;
  return (
    <div className={styles["form"]}>
      <p>{t("send.text")}</p>
      <Select
        label={t("send.open")}
        value={chosen}
        options={saved.map(({ id, lesson }) => ({
          value: id,
          label: lessonName(lesson) || t("unnamed"),
        }))}
        onChange={(next) => {
          setChosen(next);
          setSent(false);
        }}
      />
      <div className={styles["answers"]}>
        <Button kind="primary" onClick={() => void send()}>
          {t("send.send")}
        </Button>
      </div>
      <output className={styles["note"]}>{isSent && t("send.sent")}</output>
    </div>
  );
}
