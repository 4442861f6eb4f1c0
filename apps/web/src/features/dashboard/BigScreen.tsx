/** The big screen of a class: how students join, and what the class has done. No names. */
import type { LessonDocument } from "@corridor/challenge";
import { CELL, sizeOf } from "@corridor/maze";
import { MAX_RACERS, type ScreenContent, type ScreenRun } from "@corridor/protocol";
import { useEffect, useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { shownCode } from "../../model/classes/shown-code.ts";
import { useStore } from "zustand";
import type { StoreApi } from "zustand/vanilla";
import { countRacers } from "../../model/classroom/racers.ts";
import { lessonName } from "../../model/lessons/lesson-name.ts";
import { cornersOf, lineTo } from "../../simulator/protocol/tile-trail.ts";
import { Brand } from "../../ui/Brand.tsx";
import { Button } from "../../ui/Button.tsx";
import { MazeDrawing } from "../../ui/MazePicture.tsx";
import { QrCode } from "../../ui/QrCode.tsx";
import { qrPath } from "../../ui/qr-path.ts";
import type { BigScreenState } from "./big-screen-state.ts";
import { BumpMaze } from "./BumpMaze.tsx";
import { BumpPlaces } from "./BumpPlaces.tsx";
import { classTimeText } from "./class-time-text.ts";
import { LazyScreenProgram } from "./lazy-screen-program.ts";
import { LazyRaceView } from "./lazy-race-view.ts";
import { taskMaze } from "./task-maze.ts";
import styles from "./big-screen.module.css";

interface BigScreenProps {
  store: StoreApi<BigScreenState>;
  /** the buttons for theme and language */
  tools: ReactNode;
}

export function BigScreen({ store, tools }: BigScreenProps) {
  const { t, i18n } = useTranslation("dashboard", { useSuspense: false });
  const { status, code, lesson, content, ...state } = useStore(store);
  useEffect(() => {
    document.title = t("screen.pageTitle");
  }, [t, i18n.language]);
  const isOver = status === "over";
  return (
    <div className={styles["page"]}>
      <header className={styles["bar"]}>
        <Brand />
        <div className={styles["tools"]}>{tools}</div>
      </header>
      <main className={styles["main"]}>
        {isOver || code === null ? (
          <p className={styles["title"]}>{t(isOver ? "screen.over" : "screen.waiting")}</p>
        ) : (
          <>
            <h1 className={styles["title"]} lang={lesson?.language ?? undefined} dir="auto">
              {lesson === null ? "" : lessonName(lesson)}
            </h1>
            <Join code={code} />
            {!(state.isLessonReadable && state.isContentReadable) && (
              <p role="alert">{t("screen.unreadable")}</p>
            )}
            {content !== null && lesson !== null && <Results lesson={lesson} content={content} />}
          </>
        )}
      </main>
    </div>
  );
}

function Join({ code }: { code: string }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const qr = qrPath(`${location.origin}/join#${code}`);
  return (
    <section className={styles["join"]} aria-label={t("code.label")}>
      <div>
        <p className={styles["address"]} dir="ltr">
          {location.host}/join
        </p>
        <p className={styles["letters"]} dir="ltr">
          {shownCode(code)}
        </p>
      </div>
      {qr !== null && (
        <div className={styles["qr"]}>
          <QrCode code={qr} />
        </div>
      )}
    </section>
  );
}

function Results({ lesson, content }: { lesson: LessonDocument; content: ScreenContent }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { task, solved, all, medianMs, lines, run, racers, raceMaze, missing } = content;
  const [racedTask, setRacedTask] = useState<number | null>(null);
  const count = countRacers(racers);
  // Another task, or another lesson, ends the race.
  const isRacing = racedTask === task && count > 1;
  if (racedTask !== null && !isRacing) setRacedTask(null);
  return (
    <section className={styles["results"]} aria-label={t("summary.label")}>
      <div className={styles["numbers"]}>
        {lesson.tasks.length > 1 && (
          <p>{t("summary.taskOf", { task, tasks: lesson.tasks.length })}</p>
        )}
        <p className={styles["solved"]}>{t("screen.solved", { solved, count: all })}</p>
        <div className={styles["share"]} aria-hidden="true">
          <span style={{ inlineSize: `${(solved / Math.max(1, all)) * 100}%` }} />
        </div>
        {medianMs !== null && (
          <p>{t("screen.median", { time: classTimeText(medianMs), count: solved })}</p>
        )}
        {lines !== null && (
          <p>{t("screen.lines", { count: lines.value, part: lines.count, all: lines.all })}</p>
        )}
        {!isRacing && run !== null && run.program !== null && (
          <LazyScreenProgram link={run.program} running={run.line} />
        )}
        {count > 1 && !isRacing && (
          <div>
            <Button onClick={() => setRacedTask(task)}>{t("race.open", { count })}</Button>
          </div>
        )}
      </div>
      {isRacing ? (
        <LazyRaceView
          key={`${task} ${raceMaze}`}
          lesson={lesson}
          task={task}
          maze={raceMaze}
          racers={racers}
          note={missing === 0 ? null : t("race.missing", { count: missing, most: MAX_RACERS })}
          onClose={() => setRacedTask(null)}
        />
      ) : run === null ? (
        <Bumps lesson={lesson} content={content} />
      ) : (
        run.maze !== null && <Run lesson={lesson} run={run} />
      )}
    </section>
  );
}

/** Where robots bump, in the maze with most bumps. */
function Bumps({ lesson, content }: { lesson: LessonDocument; content: ScreenContent }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { task: number, bumps, bumpCounts } = content;
  const name = content.maze ?? "g1";
  const maze = taskMaze(lesson, number, name);
  const task = lesson.tasks[number - 1];
  if (maze === null || task === undefined) return null;
  return (
    <figure className={styles["picture"]}>
      <figcaption>{t("screen.bumps")}</figcaption>
      <BumpMaze maze={maze} bumps={bumps} />
      <p>
        <BumpPlaces task={task} maze={name} counts={bumpCounts} />
      </p>
    </figure>
  );
}

/** One run, without the name of its student. */
function Run({ lesson, run }: { lesson: LessonDocument; run: ScreenRun }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const maze = taskMaze(lesson, run.task, run.maze ?? "g1");
  if (maze === null) return null;
  const { columns, rows } = sizeOf(maze);
  const [x, y, heading] = run.pose;
  const at = { x: x / CELL, y: y / CELL };
  const points = lineTo(cornersOf(run), { x, y }).map(
    (each) => `${each.x / CELL},${each.y / CELL}`,
  );
  return (
    <figure className={styles["picture"]}>
      <figcaption>{t("screen.run")}</figcaption>
      <svg viewBox={`0 0 ${columns} ${rows}`} aria-hidden="true">
        <MazeDrawing maze={maze} />
        <polyline className={styles["path"]} data-solved={run.isSolved} points={points.join(" ")} />
        <g transform={`translate(${at.x} ${at.y}) rotate(${heading})`}>
          <circle className={styles["robot"]} r="0.32" />
          <path className={styles["nose"]} d="M-.14-.1 0-.26 .14-.1z" />
        </g>
      </svg>
    </figure>
  );
}
