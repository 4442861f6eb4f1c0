/** The card of a student: picture, name, state and numbers. */
import { Clock, List, RotateCcw, TriangleAlert } from "lucide";
import { memo } from "react";
import { useTranslation } from "react-i18next";
import { useShallow } from "zustand/react/shallow";
import { classNames } from "../../ui/class-names.ts";
import { Icon } from "../../ui/Icon.tsx";
import { CardClock, useMinutes } from "./CardClock.tsx";
import { useDashboard, useStudentName } from "./dashboard-context.ts";
import { StandingChip } from "./StandingChip.tsx";
import { StudentPicture } from "./StudentPicture.tsx";
import { cardFacts, type CardTime } from "./use-card.ts";
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
  // Everything that the card renders, so that it renders again only when that changes.
  const facts = useDashboard(useShallow((all) => cardFacts(all, number)));
  if (facts === null) return null;
  const { word, text, task, hasTasks, state, lines, attempts, awaySeconds } = facts;
  const name = nameOf({ student: number, name: { word, text } });
  return (
    <li
      className={classNames(
        styles["card"],
        (state === "help" || state === "stuck") && styles["urgent"],
      )}
    >
      <WatchButton
        student={number}
        time={facts}
        before={[name, t(`standing.${state}`), ...(hasTasks ? [t("card.task", { task })] : [])]}
        after={[
          ...(lines === null ? [] : [t("card.lines", { count: lines })]),
          t("card.attempts", { count: attempts }),
        ]}
        isWatched={isWatched}
        onWatch={onWatch}
      />
      <StudentPicture student={number} isOld={awaySeconds !== null} />
      <div className={styles["words"]} aria-hidden="true">
        <span className={styles["name"]} dir="auto">
          {name}
        </span>
        {state === "unverified" ? <Unverified /> : <StandingChip state={state} />}
        <span className={styles["numbers"]}>
          {hasTasks && <span>{t("card.task", { task })}</span>}
          <span>
            <Icon of={Clock} size={14} />
            <CardClock time={facts} />
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

interface WatchButtonProps extends StudentCardProps {
  time: CardTime;
  /** what a screen reader says before and after the minutes */
  before: readonly string[];
  after: readonly string[];
}

/** Covers the card, and names all of it. Renders again each minute, which the card does not. */
function WatchButton({ student, time, before, after, isWatched, onWatch }: WatchButtonProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const minutes = useMinutes(time);
  return (
    <button
      type="button"
      className={styles["watch"]}
      data-student={student}
      aria-label={[...before, t("card.minutes", { count: minutes }), ...after].join(", ")}
      aria-expanded={isWatched}
      onClick={() => onWatch(student)}
    />
  );
}

/** Too long for a chip. The card opens the student's run. */
function Unverified() {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  return (
    <span className={styles["unverified"]}>
      <Icon of={TriangleAlert} size={14} />
      <span>
        {t("watch.unverified")} <span className={styles["link"]}>{t("card.watch")}</span>
      </span>
    </span>
  );
}
