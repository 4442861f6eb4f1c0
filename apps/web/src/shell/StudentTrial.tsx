/** A lesson as students see it, in the page for teachers. */
import { useEffect, useEffectEvent, useState } from "react";
import type { TrialProps } from "../features/teach/frame/teach-slots.ts";
import { openTask, type ChallengeState } from "../model/challenge/challenge-store.ts";
import { ServicesProvider } from "../model/use-services.ts";
import { App } from "./App.tsx";
import styles from "./student-trial.module.css";
import { openStudentPage, type SurroundingPage } from "./student-page.ts";

type StudentTrialProps = TrialProps & { page: SurroundingPage };

export function StudentTrial({ page, lesson, program, onSolved, band }: StudentTrialProps) {
  const [student] = useState(() => openStudentPage(page));
  const { services } = student;
  useEffect(() => () => student.end(), [student]);
  useEffect(() => {
    services.screen.setState({ isOpening: true });
    void services.lessons.openShared(lesson, program).finally(() => {
      services.screen.setState({ isOpening: false });
    });
    // oxlint-disable-next-line react/exhaustive-deps -- opening the lesson again would lose the student's work
  }, [services]);
  const report = useEffectEvent((state: ChallengeState): void => {
    const task = openTask(state);
    const { result } = state;
    if (task === null || result.state !== "met") return;
    const { driver, lines, ticks } = result;
    const { program: written } = services.workspace.getState();
    onSolved(task, { lines, ticks, program: driver === "program" ? written : null });
  });
  useEffect(
    () =>
      services.challenge.subscribe((state, before) => {
        if (state.result !== before.result) report(state);
      }),
    [services],
  );
  return (
    <ServicesProvider value={services}>
      <div className={styles["trial"]}>
        {band}
        <div className={styles["page"]}>
          <App />
        </div>
      </div>
    </ServicesProvider>
  );
}
