/** A hand-in and a task: in how many mazes it passes, and where it fails first. */
import { Ban, Check, CircleDashed, Clock, TriangleAlert, X, type IconNode } from "lucide";
import { useTranslation } from "react-i18next";
import type { AttemptResult, Verdict } from "../../model/check/attempt-result.ts";
import { failureSentence } from "../../model/check/failure-sentence.ts";
import { diagnosisText, diagnosisWords } from "../../model/diagnosis/diagnosis-text.ts";
import { formatSeconds } from "../../text/numbers.ts";
import { Icon } from "../../ui/Icon.tsx";
import type { HandInRow } from "./check-hand-ins.ts";
import { problemSentence } from "./problem-sentence.ts";
import styles from "./hand-in-table.module.css";

const icons: Record<Verdict, IconNode> = {
  all: Check,
  enough: TriangleAlert,
  fails: X,
  "time-limit": Clock,
  "not-allowed": Ban,
  open: CircleDashed,
};

interface HandInTableRowProps {
  row: HandInRow;
  /** whether the table has a column for the task */
  hasTasks: boolean;
  /** of other lessons, by their marks */
  lessonNames: ReadonlyMap<string, string>;
}

export function HandInTableRow({ row, hasTasks, lessonNames }: HandInTableRowProps) {
  const { t, i18n } = useTranslation("teach", { useSuspense: false });
  const { number, sameAs, checked } = row;
  return (
    <tr>
      <td className={styles["number"]}>{number}</td>
      <th scope="row" className={styles["handIn"]}>
        <HandInName row={row} />
      </th>
      {hasTasks && <td data-label={t("table.task")}>{checked.ok ? checked.task.number : ""}</td>}
      {checked.ok ? (
        <>
          <td data-label={t("table.passes")}>
            <Passes result={checked.result} />
          </td>
          <td className={styles["figure"]} data-label={t("table.lines")}>
            {checked.result.lines ?? ""}
          </td>
          <td className={styles["figure"]} data-label={t("table.seconds")}>
            {checked.result.ticks === null
              ? ""
              : formatSeconds(checked.result.ticks, i18n.language)}
          </td>
          <td className={styles["first"]}>
            <FirstFailure checked={checked} />
          </td>
          <td>
            {checked.watch !== null && (
              <a
                className={styles["watch"]}
                href={checked.watch}
                target="_blank"
                rel="noopener"
                aria-label={t("table.watchLabel", { number })}
              >
                {t("table.watch")}
              </a>
            )}
          </td>
        </>
      ) : (
        <td className={styles["problem"]} colSpan={5}>
          {problemSentence(t, checked, lessonNames)}
        </td>
      )}
      <td className={styles["figure"]} data-label={t("table.sameAs")}>
        {sameAs ?? ""}
      </td>
    </tr>
  );
}

function HandInName({ row: { source, title } }: { row: HandInRow }) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const name = "file" in source ? source.file : t("table.line", { line: source.line });
  return (
    <>
      <span className={styles["name"]} dir="auto">
        {name}
      </span>
      {title !== "" && (
        <span className={styles["program"]} dir="auto">
          {title}
        </span>
      )}
    </>
  );
}

type Checked = Extract<HandInRow["checked"], { ok: true }>;

/** Where the attempt fails first and, once it is diagnosed, why. */
function FirstFailure({ checked: { task, result, diagnosis } }: { checked: Checked }) {
  const { t, i18n } = useTranslation("check", { useSuspense: false });
  const { t: why, ready } = useTranslation(["diagnosis", "words"], { useSuspense: false });
  const { language } = i18n;
  if (result.first === null) return null;
  return (
    <>
      {failureSentence({ t, language }, task.task, result.first)}
      {/* Without a known cause, the sentence above already states what happened. */}
      {ready && diagnosis !== null && diagnosis.cause !== null && (
        <span className={styles["why"]}>
          {diagnosisText(diagnosisWords(why, language), diagnosis)}
        </span>
      )}
    </>
  );
}

function Passes({ result }: { result: AttemptResult }) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const { verdict, passed, mazes } = result;
  return (
    <span className={styles["verdict"]} data-verdict={verdict}>
      <Icon of={icons[verdict]} size={16} strokeWidth={2.5} />
      <span>
        {verdict !== "not-allowed" && (
          <span className={styles["count"]}>{t("table.of", { passed, all: mazes })}</span>
        )}
        <span className={styles["word"]}>{t(`verdict.${verdict}`)}</span>
      </span>
    </span>
  );
}
