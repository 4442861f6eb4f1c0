/** Starts the race of a task on the dashboard, in a maze that the teacher chooses. */
import type { LessonDocument } from "@corridor/challenge";
import { MAX_RACERS } from "@corridor/protocol";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { countRacers, raceMazes, type RaceField } from "../../model/classroom/racers.ts";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { Select } from "../../ui/Select.tsx";
import { useDashboard, useStudentName } from "./dashboard-context.ts";
import { LazyRaceView } from "./lazy-race-view.ts";
import { useRaceMazeName } from "./race-maze-name.ts";
import styles from "./race-view.module.css";

interface RaceButtonProps {
  lesson: LessonDocument;
  /** from 1 */
  task: number;
  field: RaceField;
  /** the chosen maze, as in tiles */
  maze: string;
  onMaze: (maze: string) => void;
}

/** Nothing while fewer than two robots can race. */
export function RaceButton({ lesson, task, field, maze, onMaze }: RaceButtonProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const [isOpen, setOpen] = useState(false);
  const note = useMissingNote(field.missing);
  const count = countRacers(field.racers);
  const canRace = count > 1;
  const close = (): void => setOpen(false);
  return (
    <>
      {canRace && (
        <Button size="small" onClick={() => setOpen(true)}>
          {t("race.open", { count })}
        </Button>
      )}
      <Dialog isOpen={isOpen && canRace} onClose={close} title={t("race.title")}>
        {isOpen && canRace && (
          <>
            <MazeChoice lesson={lesson} task={task} maze={maze} onMaze={onMaze} />
            <LazyRaceView
              key={maze}
              lesson={lesson}
              task={task}
              maze={maze}
              racers={field.racers}
              note={note}
              onClose={close}
            />
          </>
        )}
      </Dialog>
    </>
  );
}

/** Nothing if the task has one maze. */
function MazeChoice({ lesson, task, maze, onMaze }: Omit<RaceButtonProps, "field">) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const nameOf = useRaceMazeName(lesson, task);
  const mazes = raceMazes(lesson.tasks[task - 1] ?? { mazes: [], unseen: null });
  if (mazes.length < 2) return null;
  return (
    <div className={styles["choice"]}>
      <span aria-hidden="true">{t("race.maze")}</span>
      <Select
        label={t("race.maze")}
        value={maze}
        options={mazes.map((value) => ({ value, label: nameOf(value) }))}
        onChange={onMaze}
      />
    </div>
  );
}

/** Names the students whose programs have no room; null: there are none. */
function useMissingNote(missing: readonly number[]): string | null {
  const { t, i18n } = useTranslation("dashboard", { useSuspense: false });
  const students = useDashboard((state) => state.students);
  const nameOf = useStudentName();
  if (missing.length === 0) return null;
  const names = missing.flatMap((student) => {
    const found = students.get(student);
    return found === undefined ? [] : [nameOf(found)];
  });
  const list = new Intl.ListFormat(i18n.language, { type: "conjunction" });
  return t("race.missingNames", { names: list.format(names), most: MAX_RACERS });
}
