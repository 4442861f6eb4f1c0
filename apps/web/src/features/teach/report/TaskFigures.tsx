/** The time of each student as a bar, in the order of the table. */
import type { TaskReport } from "@corridor/report";
import { useTranslation } from "react-i18next";
import { timeText, columnName } from "./report-numbers.ts";
import styles from "./report.module.css";

/** Candidates for the distance of two lines of the scale, in seconds. */
const STEPS = [10, 30, 60, 120, 300, 600, 1_800, 3_600, 7_200];
const MOST_LINES = 6;
/** Up to this number of students, each bar has its own line with name and time. */
const MOST_NAMED = 16;

export function TaskFigures({ tasks }: { tasks: readonly TaskReport[] }) {
  const { t } = useTranslation("report", { useSuspense: false });
  return (
    <section className={styles["figures"]} aria-label={t("figures.title")}>
      {tasks.map((task) => (
        <TaskFigure key={task.task} task={task} />
      ))}
    </section>
  );
}

function TaskFigure({ task: { task, bars, time } }: { task: TaskReport }) {
  const { t } = useTranslation("report", { useSuspense: false });
  const longest = time.longest ?? 0;
  const step = STEPS.find((each) => longest / each <= MOST_LINES) ?? longest;
  const top = Math.max(step, Math.ceil(longest / step) * step);
  const label = t("figures.of", { task: columnName(task) });
  if (bars.length <= MOST_NAMED) {
    return (
      <figure className={styles["figure"]}>
        <FigureCaption label={label} />
        <ol className={styles["lines"]} aria-label={label}>
          {bars.map(({ student, seconds }, at) => (
            // oxlint-disable-next-line react/no-array-index-key -- anonymous students have no other identity
            <li key={at} className={styles["line"]}>
              <span className={styles["who"]} dir="auto">
                {student ?? at + 1}
              </span>
              <span className={styles["room"]} aria-hidden="true">
                <span
                  className={styles["fill"]}
                  style={{ inlineSize: `${((seconds ?? 0) / top) * 100}%` }}
                />
              </span>
              <span className={styles["time"]}>
                {seconds === null ? t("figures.notSolved") : timeText(seconds)}
              </span>
            </li>
          ))}
        </ol>
      </figure>
    );
  }
  const lines = Array.from({ length: Math.round(top / step) + 1 }, (_, at) => at * step);
  return (
    <figure className={styles["figure"]}>
      <FigureCaption label={label} />
      <div className={styles["chart"]}>
        {lines.map((seconds) => (
          <span
            key={seconds}
            className={styles["scale"]}
            style={{ insetBlockEnd: `${(seconds / top) * 100}%` }}
            aria-hidden
          >
            {timeText(seconds)}
          </span>
        ))}
        <ol
          className={styles["bars"]}
          // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- scrolls by keyboard
          tabIndex={0}
          aria-label={label}
        >
          {bars.map(({ student, seconds }, at) => (
            // oxlint-disable-next-line react/no-array-index-key -- anonymous students have no other identity
            <li key={at} className={styles["bar"]}>
              <span
                className={styles["fill"]}
                style={{ blockSize: `${((seconds ?? 0) / top) * 100}%` }}
                aria-hidden
              />
              <span className="visually-hidden">
                {t("figures.bar", {
                  student: student ?? String(at + 1),
                  time: seconds === null ? t("figures.notSolved") : timeText(seconds),
                })}
              </span>
            </li>
          ))}
        </ol>
      </div>
    </figure>
  );
}

function FigureCaption({ label }: { label: string }) {
  const { t } = useTranslation("report", { useSuspense: false });
  return (
    <figcaption>
      <p className={styles["heading"]}>{label}</p>
      <p className={styles["note"]}>{t("figures.unit")}</p>
    </figcaption>
  );
}
