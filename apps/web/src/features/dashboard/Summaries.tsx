/** What the class has done in a task: solved, times, lines, attempts, and where robots bump. */
import type { LessonDocument } from "@corridor/challenge";
import { useMemo, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import type { Bar, ClassSummary } from "../../model/classroom/class-summary.ts";
import { mostBumped } from "../../model/classroom/most-bumped.ts";
import { summaryOf } from "../../model/classroom/class-summary.ts";
import { isClassPaused, resultsTask } from "../../model/classroom/dashboard.ts";
import { chosenMaze, raceField, type RaceChoice } from "../../model/classroom/racers.ts";
import { groups, type StudentGroup } from "../../model/classroom/student-group.ts";
import { localNumber } from "../../text/numbers.ts";
import { Select } from "../../ui/Select.tsx";
import { BumpMaze } from "./BumpMaze.tsx";
import { BumpPlaces } from "./BumpPlaces.tsx";
import { classTimeText } from "./class-time-text.ts";
import { useContent, useDashboard } from "./dashboard-context.ts";
import { RaceButton } from "./RaceButton.tsx";
import { taskMaze } from "./task-maze.ts";
import styles from "./summaries.module.css";

interface SummariesProps {
  raceChoice: RaceChoice | null;
  onRaceChoice: (choice: RaceChoice) => void;
}

export function Summaries({ raceChoice, onRaceChoice }: SummariesProps) {
  const { t, i18n } = useTranslation("dashboard", { useSuspense: false });
  const lesson = useDashboard((state) => state.lesson);
  const students = useDashboard((state) => state.students);
  const shown = useDashboard((state) => state.shown);
  const verifications = useDashboard((state) => state.verifications);
  const expected = useDashboard(({ classroom }) => classroom?.expected ?? null);
  const isPaused = useDashboard(isClassPaused);
  const { dashboard } = useContent();
  const task = useDashboard(resultsTask);
  const tasks = lesson?.tasks.length ?? 1;
  const summary = useMemo(
    () => summaryOf(task, students, shown, verifications, { expected, isPaused }),
    [task, students, shown, verifications, expected, isPaused],
  );
  if (students.size === 0) return null;
  const limit = lesson?.tasks[task - 1]?.allowed.lines ?? null;
  const { medianMs, commonLines, medianAttempts } = summary;
  const none = t("summary.none");
  return (
    <section className={styles["summaries"]} aria-label={t("summary.label")}>
      <div className={styles["part"]}>
        <div className={styles["first"]}>
          <h2 className={styles["name"]}>{t("summary.solved")}</h2>
          {lesson !== null && (
            <RaceButton
              lesson={lesson}
              task={task}
              field={raceField(task, verifications)}
              maze={chosenMaze(lesson, task, raceChoice)}
              onMaze={(maze) => onRaceChoice({ task, maze })}
            />
          )}
        </div>
        <div className={styles["first"]}>
          <p className={styles["figure"]}>
            <strong>{summary.solved}</strong> {t("summary.ofStudents", { count: summary.all })}
          </p>
          {tasks > 1 && (
            <Select
              label={t("summary.task")}
              value={String(task)}
              options={Array.from({ length: tasks }, (_, at) => ({
                value: String(at + 1),
                label: t("summary.taskOf", { task: at + 1, tasks }),
              }))}
              onChange={(value) => dashboard.chooseTask(Number(value))}
            />
          )}
        </div>
        <Shares groups={groupsShown(isPaused, tasks > 1)} summary={summary} />
      </div>
      <Part
        name={t("summary.time")}
        figure={medianMs === null ? none : classTimeText(medianMs)}
        note={medianMs === null ? "" : t("summary.medianMinutes")}
        bars={summary.times}
        unit={t("chart.minutes")}
      />
      <Part
        name={t("summary.lines")}
        figure={commonLines === null ? none : String(commonLines.value)}
        note={
          commonLines === null
            ? ""
            : limit === null
              ? t("summary.common", { part: commonLines.count, all: commonLines.all })
              : t("summary.commonLimit", { part: commonLines.count, all: commonLines.all, limit })
        }
        bars={summary.lines}
        unit={t("chart.lines")}
        most={limit}
      />
      <Part
        name={t("summary.attempts")}
        figure={medianAttempts === null ? none : localNumber(String(medianAttempts), i18n.language)}
        note={medianAttempts === null ? "" : t("summary.median")}
        bars={summary.attempts}
        unit={t("chart.attempts")}
      />
      {lesson !== null && <Bumps lesson={lesson} task={task} />}
    </section>
  );
}

/** The same ones whatever students do, so that their places do not change. */
function groupsShown(isPaused: boolean, hasTasks: boolean): StudentGroup[] {
  return groups.filter((group) => {
    if (group === "paused") return isPaused;
    if (group === "driving" || group === "writing") return !isPaused;
    return group !== "elsewhere" || hasTasks;
  });
}

interface SharesProps {
  groups: readonly StudentGroup[];
  summary: ClassSummary;
}

/** The students by what they do, as a bar with its legend. */
function Shares({ groups: shown, summary }: SharesProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const counts = summary.groups;
  return (
    <>
      <div className={styles["shares"]} aria-hidden="true">
        {shown.map(
          (group) =>
            counts[group] > 0 && (
              <span key={group} data-share={group} style={{ flexGrow: counts[group] }} />
            ),
        )}
      </div>
      <dl className={styles["legend"]}>
        {shown.map((group) => (
          <div key={group}>
            <dt data-share={group}>{t(`share.${group}`)}</dt>
            <dd>{counts[group]}</dd>
          </div>
        ))}
      </dl>
    </>
  );
}

interface PartProps {
  name: string;
  figure: string;
  note: string;
  bars: readonly Bar[];
  /** what the bars count, and by what */
  unit: string;
  /** values up to this one are within the limit of the task */
  most?: number | null;
}

function Part({ name, figure, note, bars, unit, most = null }: PartProps): ReactNode {
  const highest = Math.max(1, ...bars.map(({ count }) => count));
  return (
    <div className={styles["part"]}>
      <h2 className={styles["name"]}>{name}</h2>
      <p className={styles["figure"]}>
        <strong>{figure}</strong> {note}
      </p>
      {bars.length > 0 && (
        <ol className={styles["bars"]}>
          {bars.map(({ value, count, isOpen }) => (
            <li key={value} className={styles["bar"]} data-good={most !== null && value <= most}>
              <span>{count > 0 && count}</span>
              <span
                className={styles["column"]}
                style={{ blockSize: `${(count / highest) * 100}%` }}
              />
              <span className={styles["value"]}>
                {value}
                {isOpen && "+"}
              </span>
            </li>
          ))}
        </ol>
      )}
      {bars.length > 0 && <p className={styles["unit"]}>{unit}</p>}
    </div>
  );
}

function Bumps({ lesson, task }: { lesson: LessonDocument; task: number }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const bumps = useDashboard((state) => state.bumps);
  const { maze: name, cells, counts } = mostBumped(task, bumps);
  const maze = taskMaze(lesson, task, name);
  const document = lesson.tasks[task - 1];
  if (maze === null || document === undefined) return null;
  const count = counts.most + counts.given + counts.unseen;
  return (
    <div className={styles["part"]}>
      <h2 className={styles["name"]}>{t("summary.bumps")}</h2>
      {count === 0 ? (
        <p className={styles["figure"]}>{t("summary.noBumps")}</p>
      ) : (
        <p className={styles["figure"]}>
          <strong>{count}</strong> {t("summary.bumpWord", { count })}
        </p>
      )}
      <div className={styles["maze"]}>
        <BumpMaze maze={maze} bumps={cells} />
      </div>
      {count > 0 && (
        <p className={styles["places"]}>
          <BumpPlaces task={document} maze={name} counts={counts} />
        </p>
      )}
    </div>
  );
}
