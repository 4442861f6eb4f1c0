/** Opens the lesson that the students worked on. */
import { FileDown, FolderOpen } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Button } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { chooseFiles } from "../../ui/incoming-files.ts";
import { TextField } from "../../ui/TextField.tsx";
import type { HandInsWork } from "./hand-ins-work.ts";
import { LessonProblemNote } from "./lessons/LessonProblemNote.tsx";
import styles from "./lesson-opener.module.css";

export function LessonOpener({ work }: { work: HandInsWork }) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const isOpening = useStore(work.store, (state) => state.isOpening);
  const problem = useStore(work.store, (state) => state.problem);
  const [link, setLink] = useState("");
  return (
    <section className={styles["opener"]} aria-label={t("lesson.heading")}>
      <p>{t("lesson.intro")}</p>
      <form
        className={styles["form"]}
        onSubmit={(event) => {
          event.preventDefault();
          if (link.trim() !== "") void work.openAddress(link);
        }}
      >
        <div className={styles["field"]}>
          <TextField
            label={t("lesson.link")}
            value={link}
            onChange={setLink}
            dir="ltr"
            spellCheck={false}
            aria-invalid={problem !== null}
          />
        </div>
        <Button kind="primary" type="submit" disabled={isOpening}>
          {t("lesson.open")}
        </Button>
        <Button
          icon={<Icon of={FolderOpen} />}
          onClick={() => chooseFiles((files) => void work.addFiles(files))}
        >
          {t("lesson.file")}
        </Button>
      </form>
      <p className={styles["drop"]}>
        <Icon of={FileDown} size={16} />
        {t("lesson.drop")}
      </p>
      {problem !== null && <LessonProblemNote problem={problem} />}
      <output className="visually-hidden">{isOpening ? t("lesson.opening") : ""}</output>
    </section>
  );
}
