/** The answers to the survey. The teacher types how many students made a related mistake. */
import type { QuestionReport } from "@corridor/report";
import { useTranslation } from "react-i18next";
import { isStudyQuestion } from "../lessons/study-2013.ts";
import { directionOf } from "../../../text/direction.ts";
import { classNames } from "../../../ui/class-names.ts";
import type { QuestionText } from "./question-texts.ts";
import { columnName, decimalText, percentText } from "./report-numbers.ts";
import field from "../../../ui/field.module.css";
import styles from "./report.module.css";

interface SurveyTableProps {
  questions: readonly QuestionReport[];
  /** the texts of the questions, by their ids */
  texts: ReadonlyMap<string, QuestionText>;
  students: number;
  /** @param count null: not counted */
  onMistakes: (question: string, count: number | null) => void;
}

export function SurveyTable({ questions, texts, students, onMistakes }: SurveyTableProps) {
  const { t, i18n } = useTranslation("report", { useSuspense: false });
  const { language } = i18n;
  return (
    <div className={styles["section"]}>
      <h3 className={styles["heading"]}>{t("survey.title")}</h3>
      <p className={styles["note"]}>{t("survey.note")}</p>
      {/* oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- scrolls by keyboard */}
      <section className={styles["scroll"]} tabIndex={0} aria-label={t("survey.title")}>
        <table className={styles["table"]}>
          <thead>
            <tr>
              <th scope="col">{t("survey.question")}</th>
              {[1, 2, 3, 4, 5].map((answer) => (
                <th key={answer} scope="col" className={styles["end"]}>
                  {answer}
                </th>
              ))}
              <th scope="col" className={styles["end"]}>
                {t("survey.skipped")}
              </th>
              <th scope="col" className={styles["end"]}>
                {t("columns.mean")}
              </th>
              <th scope="col" className={styles["end"]}>
                {t("survey.mistakes")}
              </th>
            </tr>
          </thead>
          <tbody>
            {questions.map(({ id, counts, skipped, mean, mistakes }) => (
              <tr key={id}>
                <th scope="row" className={styles["question"]}>
                  <Question id={id} text={texts.get(id)} />
                </th>
                {counts.map((count, at) => (
                  // oxlint-disable-next-line react/no-array-index-key -- the answers 1 to 5
                  <td key={at}>{count}</td>
                ))}
                <td>{skipped}</td>
                <td>{mean === null ? t("few") : decimalText(mean, language, 1)}</td>
                <td>{mistakes === null ? "–" : percentText(mistakes.share, language)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </section>
      <fieldset className={styles["mistakes"]}>
        <legend>{t("survey.mistakesOf")}</legend>
        {questions.map(({ id, mistakes }) => (
          <label key={id} className={styles["mistake"]}>
            <Question id={id} text={texts.get(id)} />
            <input
              type="number"
              inputMode="numeric"
              min={0}
              max={students}
              className={classNames(field["field"], styles["count"])}
              value={mistakes?.students ?? ""}
              onChange={({ target }) => {
                const count = Number(target.value);
                const isCount = target.value !== "" && Number.isInteger(count);
                onMistakes(id, isCount ? Math.min(Math.max(count, 0), students) : null);
              }}
            />
          </label>
        ))}
      </fieldset>
    </div>
  );
}

interface QuestionProps {
  id: string;
  /** in the lesson that asked it; undefined: unknown */
  text: QuestionText | undefined;
}

function Question({ id, text }: QuestionProps) {
  const { t } = useTranslation("teach", { useSuspense: false });
  if (text !== undefined) {
    const { question, language } = text;
    return (
      <span lang={language ?? undefined} dir={directionOf(language)}>
        {question}
      </span>
    );
  }
  return isStudyQuestion(id) ? t(`study.questions.${id}`) : columnName(id);
}
