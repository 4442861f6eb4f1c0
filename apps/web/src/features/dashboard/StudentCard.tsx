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

const noTime: CardTime = { minutes: 0, startedAt: null, seconds: 0 };

export const StudentCard = memo(function StudentCard(props: StudentCardProps) {
  const { student: number, isWatched, onWatch } = props;
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const nameOf = useStudentName();
  // Everything that the card renders, so that it renders again only when that changes.
  const facts = useDashboard(useShallow((all) => cardFacts(all, number)));
  const minutes = useMinutes(facts ?? noTime);
  if (facts === null) return null;
  const { word, text, task, hasTasks, state, lines, attempts, awaySeconds } = facts;
  const { startedAt, seconds } = facts;
  const name = nameOf({ student: number, name: { word, text } });
  const spoken = [
    name,
    t(`standing.${state}`),
    ...(hasTasks ? [t("card.task", { task })] : []),
    t("card.minutes", { count: minutes }),
    ...(lines === null ? [] : [t("card.lines", { count: lines })]),
    t("card.attempts", { count: attempts }),
  ];
  return (
    <li
      className={classNames(
        styles["card"],
        (state === "help" || state === "stuck") && styles["urgent"],
      )}
    >
      <button
        type="button"
        className={styles["watch"]}
        data-student={number}
        aria-label={spoken.join(", ")}
        aria-expanded={isWatched}
        onClick={() => onWatch(number)}
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
            <CardClock minutes={minutes} startedAt={startedAt} seconds={seconds} />
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
