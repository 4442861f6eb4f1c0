/** The questions of the class's lesson, each answered from 1 to 5 or skipped. */
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { ClassWork } from "../../model/classes/class-work.ts";
import { directionOf } from "../../text/direction.ts";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { Segmented } from "../../ui/Segmented.tsx";
import styles from "./survey-dialog.module.css";

const ratings = ["1", "2", "3", "4", "5"] as const;
const SKIPPED = "skip";
type Answer = (typeof ratings)[number] | typeof SKIPPED;

export function SurveyDialog({ work }: { work: ClassWork }) {
  const { t } = useTranslation("join", { useSuspense: false });
  const isOpen = useStore(work.survey, (state) => state.isOpen);
  return (
    <Dialog
      isOpen={isOpen}
      onClose={() => work.closeSurvey()}
      title={t("survey.title")}
      subtitle={t("survey.scale")}
      width="narrow"
    >
      <Questions work={work} />
    </Dialog>
  );
}

function Questions({ work }: { work: ClassWork }) {
  const { t } = useTranslation("join", { useSuspense: false });
  const document = useStore(work.lesson.state, (state) => state.document);
  const [answers, setAnswers] = useState<ReadonlyMap<string, Answer>>(new Map());
  const questions = document?.survey ?? [];
  const answerTo = (id: string): Answer => answers.get(id) ?? SKIPPED;
  const options = [
    ...ratings.map((value) => ({ value, label: value })),
    { value: SKIPPED, label: t("survey.skip") } as const,
  ];
  return (
    <form
      className={styles["questions"]}
      onSubmit={(event) => {
        event.preventDefault();
        work.answer(questions.map(({ id }) => ({ id, answer: ratingOf(answerTo(id)) })));
      }}
    >
      {questions.map(({ id, question }) => (
        <Segmented
          key={id}
          showLabel
          label={
            <span
              className={styles["question"]}
              lang={document?.language ?? undefined}
              dir={directionOf(document?.language ?? null)}
            >
              {question}
            </span>
          }
          value={answerTo(id)}
          options={options}
          onChange={(answer) => setAnswers(new Map(answers).set(id, answer))}
        />
      ))}
      <p className={styles["note"]}>{t("survey.note")}</p>
      <Button kind="primary" type="submit">
        {t("survey.send")}
      </Button>
    </form>
  );
}

function ratingOf(answer: Answer): number | null {
  return answer === SKIPPED ? null : Number(answer);
}
