/** Starts the race of a task on the dashboard. */
import type { LessonDocument } from "@corridor/challenge";
import type { Racer } from "@corridor/protocol";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { countRacers } from "../../model/classroom/racers.ts";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { LazyRaceView } from "./lazy-race-view.ts";

interface RaceButtonProps {
  lesson: LessonDocument;
  /** from 1 */
  task: number;
  racers: readonly Racer[];
}

/** Nothing while fewer than two robots can race. */
export function RaceButton({ lesson, task, racers }: RaceButtonProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const [isOpen, setOpen] = useState(false);
  const count = countRacers(racers);
  const close = (): void => setOpen(false);
  return (
    <>
      {count > 1 && (
        <Button size="small" onClick={() => setOpen(true)}>
          {t("race.open", { count })}
        </Button>
      )}
      <Dialog isOpen={isOpen} onClose={close} title={t("race.title")}>
        {isOpen && <LazyRaceView lesson={lesson} task={task} racers={racers} onClose={close} />}
      </Dialog>
    </>
  );
}
