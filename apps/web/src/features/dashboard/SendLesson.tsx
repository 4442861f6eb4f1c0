/**
 * Sends a lesson of this device to the class. It opens beside the work of the students. The
 * dashboard shows results of the newest lesson only, so the report of the one before is saved first.
 */
import { parseLesson } from "@corridor/challenge";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { lessonName } from "../../model/lessons/lesson-name.ts";
import { storageOrNone } from "../../model/storage/key-value-storage.ts";
import { SavedLessons } from "../../model/teaching/saved-lessons.ts";
import { SharedLessons } from "../../model/teaching/shared-lessons.ts";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { ProblemNote } from "../../ui/ProblemNote.tsx";
import { Select } from "../../ui/Select.tsx";
import { useContent } from "./dashboard-context.ts";
import { useReport, type ReportPlace } from "./use-report.ts";
import styles from "./dashboard.module.css";

export interface SendLessonProps {
  isOpen: boolean;
  onClose: () => void;
  /** of the class; may be empty */
  label: string;
}

export function SendLesson({ isOpen, onClose, label }: SendLessonProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  return (
    <Dialog isOpen={isOpen} onClose={onClose} title={t("send.title")} width="narrow">
      {isOpen && <SendForm onClose={onClose} label={label} />}
    </Dialog>
  );
}

function SendForm({ onClose, label }: Pick<SendLessonProps, "onClose" | "label">) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { calls, dashboard, report } = useContent();
  const { saveOnDevice } = useReport(label);
  const [device] = useState(() => storageOrNone(() => localStorage));
  const [saved] = useState(() =>
    new SavedLessons(device).list().filter(({ lesson }) => parseLesson(lesson).ok),
  );
  const [chosen, setChosen] = useState(saved[0]?.id ?? "");
  const [state, setState] = useState<"open" | "sent" | "not-saved">("open");
  /** of the report of the lesson before; null: there is none */
  const [place, setPlace] = useState<ReportPlace | null>(null);
  const send = async (): Promise<void> => {
    const found = saved.find(({ id }) => id === chosen);
    if (found === undefined) return;
    if (dashboard.store.getState().students.size > 0) {
      try {
        setPlace(await saveOnDevice());
      } catch {
        setState("not-saved");
        return;
      }
    }
    const refusal = await calls.sendLesson(found.lesson);
    report(refusal);
    if (refusal !== null) {
      onClose();
      return;
    }
    new SharedLessons(device).add(found.lesson);
    setState("sent");
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
          setState("open");
        }}
      />
      <div className={styles["answers"]}>
        <Button kind="primary" onClick={() => void send()}>
          {t("send.send")}
        </Button>
      </div>
      {state === "not-saved" && (
        <ProblemNote>
          <p>{t("end.failed")}</p>
        </ProblemNote>
      )}
      <output className={styles["note"]}>
        {state === "sent" && (
          <>
            <p>{t("send.sent")}</p>
            {place !== null && <p>{t(place.id === null ? "end.savedFile" : "send.saved")}</p>}
          </>
        )}
      </output>
    </div>
  );
}
