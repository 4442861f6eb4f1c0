/** The dashboard: the whole class on one page. */
import { useCallback, useEffect, useMemo, useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { ClassCalls, ClassRefusal } from "../../model/classroom/class-calls.ts";
import type { Dashboard } from "../../model/classroom/dashboard.ts";
import type { OwnClass } from "../../model/classroom/own-classes.ts";
import type { RaceChoice } from "../../model/classroom/racers.ts";
import { lessonName } from "../../model/lessons/lesson-name.ts";
import type { SavedReports } from "../../model/teaching/saved-reports.ts";
import { Button } from "../../ui/Button.tsx";
import { ErrorBoundary } from "../../ui/ErrorBoundary.tsx";
import { ProblemNote } from "../../ui/ProblemNote.tsx";
import { Announcements } from "./Announcements.tsx";
import { ClassFoot } from "./ClassFoot.tsx";
import { ClassHead } from "./ClassHead.tsx";
import { ClassUnreached } from "./ClassUnreached.tsx";
import { DashboardProvider, type StudentNotes } from "./dashboard-context.ts";
import { DashboardBar, DashboardBarEnd } from "./DashboardBar.tsx";
import { DashboardFrame } from "./DashboardFrame.tsx";
import { EndDialog } from "./EndDialog.tsx";
import { LessonOver } from "./LessonOver.tsx";
import { SendLesson } from "./lazy-send-lesson.ts";
import { StudentCards } from "./StudentCards.tsx";
import { Summaries } from "./Summaries.tsx";
import type { ReportPlace } from "./use-report.ts";
import { useScreens } from "./use-screens.ts";
import { WatchSheet } from "./WatchSheet.tsx";
import styles from "./dashboard.module.css";

interface DashboardPageProps {
  dashboard: Dashboard;
  calls: ClassCalls;
  /** on this device */
  reports: SavedReports;
  room: OwnClass;
  notes: StudentNotes;
  /** stores the label of the class on the device */
  onLabel: (label: string) => void;
  /** the buttons for theme and language */
  tools: ReactNode;
}

export function DashboardPage(props: DashboardPageProps) {
  const { dashboard, calls, reports, room, notes, onLabel, tools } = props;
  const { t, i18n } = useTranslation("dashboard", { useSuspense: false });
  const [label, setLabel] = useState(room.label);
  const [hidesNames, setHidesNames] = useState(false);
  const [isEnding, setEnding] = useState(false);
  const [watched, setWatched] = useState<number | null>(null);
  const [saved, setSaved] = useState<ReportPlace | null>(null);
  const [isSending, setSending] = useState(false);
  /** whose run is on the big screens */
  const [screened, setScreened] = useState<number | null>(null);
  const [raceChoice, setRaceChoice] = useState<RaceChoice | null>(null);
  const endRun = useCallback(() => setScreened(null), []);
  useScreens(dashboard, { student: screened, race: raceChoice, onRunEnd: endRun });
  const [refusal, report] = useState<ClassRefusal | null>(null);
  const status = useStore(dashboard.store, (state) => state.status.kind);
  const lesson = useStore(dashboard.store, (state) => state.lesson);
  useEffect(() => {
    document.title = t("title");
  }, [t, i18n.language]);
  const content = useMemo(
    () => ({ id: room.id, dashboard, calls, reports, notes, hidesNames, report }),
    [room.id, dashboard, calls, reports, notes, hidesNames],
  );
  const isOver = status === "over" || status === "refused";
  return (
    <ErrorBoundary onError={() => undefined}>
      <DashboardProvider value={content}>
        <DashboardFrame
          hasSheet={watched !== null && !isOver}
          bar={
            <DashboardBar
              label={label}
              onLabel={(next) => {
                setLabel(next);
                onLabel(next);
              }}
            />
          }
          end={
            <DashboardBarEnd
              isOver={isOver}
              hidesNames={hidesNames}
              onHideNames={setHidesNames}
              onSend={() => setSending(true)}
              onEnd={() => setEnding(true)}
              room={room}
              tools={tools}
            />
          }
        >
          {isOver ? (
            <LessonOver kind={status} label={label} saved={saved} />
          ) : (
            <div className={styles["content"]}>
              <LostNote dashboard={dashboard} />
              <ClassUnreached />
              {refusal !== null && (
                <ProblemNote>
                  <p>{t(`refusals.${refusal}`)}</p>
                  <Button size="small" onClick={() => report(null)}>
                    {t("close")}
                  </Button>
                </ProblemNote>
              )}
              <ClassHead name={lesson === null ? "" : lessonName(lesson) || t("unnamed")} />
              <Summaries raceChoice={raceChoice} onRaceChoice={setRaceChoice} />
              <StudentCards onWatch={setWatched} watched={watched} />
              <Announcements />
              <ClassFoot label={label} onEnd={() => setEnding(true)} />
            </div>
          )}
          {watched !== null && !isOver && (
            <WatchSheet
              key={watched}
              student={watched}
              isOnScreens={watched === screened}
              onScreens={(isShown) => setScreened(isShown ? watched : null)}
              onClose={() => setWatched(null)}
            />
          )}
          <SendLesson
            isOpen={isSending && !isOver}
            onClose={() => setSending(false)}
            label={label}
          />
          <EndDialog
            isOpen={isEnding && !isOver}
            onClose={() => setEnding(false)}
            label={label}
            saved={saved}
            onSaved={setSaved}
          />
        </DashboardFrame>
      </DashboardProvider>
    </ErrorBoundary>
  );
}

function LostNote({ dashboard }: { dashboard: Dashboard }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const seconds = useStore(dashboard.store, ({ lostAt, now }) =>
    lostAt === null ? null : Math.max(0, Math.floor((now - lostAt) / 1_000)),
  );
  if (seconds === null) return null;
  return (
    <ProblemNote>
      <p>{t("lost.title")}</p>
      {/* Announced once, without the time. */}
      <p aria-hidden="true">{t("lost.age", { seconds })}</p>
      <p>{t("lost.continue")}</p>
    </ProblemNote>
  );
}
