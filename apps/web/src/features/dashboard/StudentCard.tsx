/** The card of a student: picture, name, state and numbers. */
import { Clock, List, RotateCcw } from "lucide";
import { memo } from "react";
import { useTranslation } from "react-i18next";
import { useShallow } from "zustand/react/shallow";
import { openTask } from "../../model/classroom/standing.ts";
import { classNames } from "../../ui/class-names.ts";
import { Icon } from "../../ui/Icon.tsx";
import { clockText } from "./clock-text.ts";
import { useDashboard, useStudentName } from "./dashboard-context.ts";
import { StandingChip } from "./StandingChip.tsx";
import { StudentPicture } from "./StudentPicture.tsx";
import { cardNumbers, cardState } from "./use-card.ts";
import styles from "./student-card.module.css";

interface StudentCardProps {
  student: number;
  isWatched: boolean;
  onWatch: (student: number) => void;
}

export const StudentCard = memo(function StudentCard(props: StudentCardProps) {
  const { student: number, isWatched, onWatch } = props;
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const nameOf = useStudentName();
  const student = useDashboard(({ students }) => students.get(number));
  const state = useDashboard((all) =>
    student === undefined ? "not-here" : cardState(all, student),
  );
  const { seconds, lines, attempts } = useDashboard(
    useShallow((all) =>
      student === undefined ? { seconds: 0, lines: null, attempts: 0 } : cardNumbers(all, student),
    ),
  );
  const awaySeconds = useDashboard(({ awaySince, lostAt, now }) => {
    const since = awaySince.get(number) ?? lostAt;
    const age = since === null ? 0 : Math.floor((now - since) / 1_000);
    return age >= OLD_SECONDS ? age : null;
  });
  const hasTasks = useDashboard(({ lesson }) => (lesson?.tasks.length ?? 1) > 1);
  if (student === undefined) return null;
  const name = nameOf(student);
  const task = openTask(student);
  const facts = [
    name,
    t(`standing.${state}`),
    ...(hasTasks ? [t("card.task", { task })] : []),
    t("card.minutes", { count: Math.floor(seconds / 60) }),
    ...(lines === null ? [] : [t("card.lines", { count: lines })]),
    t("card.attempts", { count: attempts }),
  ];
  return (
    <li
      className={classNames(
        styles["card"],
        (state === "help" || state === "stuck") && styles["urgent"],
        awaySeconds !== null && styles["old"],
      )}
    >
      <button
        type="button"
        className={styles["watch"]}
        data-student={number}
        aria-label={facts.join(", ")}
        aria-expanded={isWatched}
        onClick={() => onWatch(number)}
      />
      <StudentPicture student={number} />
      <div className={styles["words"]} aria-hidden="true">
        <span className={styles["name"]} dir="auto">
          {name}
        </span>
        <StandingChip state={state} />
        <span className={styles["numbers"]}>
          {hasTasks && <span>{t("card.task", { task })}</span>}
          <span>
            <Icon of={Clock} size={14} />
            {clockText(seconds * 1_000)}
          </span>
          {lines !== null && (
            <span>
              <Icon of={List} size={14} />
              {lines}
            </span>
          )}
          <span>
            <Icon of={RotateCcw} size={14} />
            {attempts}
          </span>
          {awaySeconds !== null && <span>{t("card.old", { seconds: awaySeconds })}</span>}
        </span>
      </div>
    </li>
  );
});

/** A picture that is older than this is grey. */
const OLD_SECONDS = 20;
