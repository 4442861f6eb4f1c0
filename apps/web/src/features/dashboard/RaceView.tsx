/** A race of the verified programs of a task, together in one maze. Robots have numbers, no names. */
import { CELL, sizeOf, type MazeDocument } from "@corridor/maze";
import { TICKS_PER_SECOND } from "@corridor/protocol";
import { useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { countRacers } from "../../model/classroom/racers.ts";
import { createWorkerPool } from "../../simulator/worker-pool.ts";
import { formatSeconds } from "../../text/numbers.ts";
import { Button } from "../../ui/Button.tsx";
import { MazeDrawing } from "../../ui/MazePicture.tsx";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import { lastTick, poseAt, raceSpeed, type RacePose } from "./race-motion.ts";
import { racePlaces, type RacePlace } from "./race-places.ts";
import { startRace, type RaceRobot, type RaceStart } from "./start-race.ts";
import { taskMaze } from "./task-maze.ts";
import styles from "./race-view.module.css";

/** The clock shows tenths of a second. */
const TICKS_PER_TENTH = TICKS_PER_SECOND / 10;
/** Rows of the list of results. */
const MOST_RESULTS = 3;

export interface RaceViewProps extends RaceStart {
  /** which students are not in the race, and why; null: all are */
  note: string | null;
  onClose: () => void;
}

/** Later solutions take part in the next race. */
export function RaceView({ note, onClose, ...start }: RaceViewProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const [starters] = useState(start);
  const [robots, setRobots] = useState<RaceRobot[] | "failed" | null>(null);
  useEffect(() => {
    const pool = createWorkerPool();
    let isShown = true;
    startRace(pool, starters).then(
      (found) => isShown && setRobots(found ?? "failed"),
      () => isShown && setRobots("failed"),
    );
    return () => {
      isShown = false;
      pool.close();
    };
  }, [starters]);
  const maze = taskMaze(starters.lesson, starters.task, starters.maze);
  const isIncomplete = Array.isArray(robots) && robots.length < starters.racers.length;
  return (
    <figure className={styles["race"]}>
      <figcaption className="visually-hidden">{t("race.title")}</figcaption>
      {robots === "failed" && <p role="alert">{t("race.failed")}</p>}
      {isIncomplete && <p role="alert">{t("race.unreadable")}</p>}
      {note !== null && <p>{note}</p>}
      {Array.isArray(robots) && robots.length > 0 && maze !== null ? (
        <Track maze={maze} robots={robots} onClose={onClose} />
      ) : (
        <div className={styles["bar"]}>
          <Button onClick={onClose}>{t("race.close")}</Button>
        </div>
      )}
    </figure>
  );
}

function transformsOf({ x, y, heading }: RacePose): { place: string; turn: string } {
  return { place: `translate(${x / CELL} ${y / CELL})`, turn: `rotate(${heading})` };
}

interface RobotProps {
  number: number;
  /** students with its program */
  count: number;
  turn: string | undefined;
  lane: RacePlace | undefined;
}

/** One robot at its lane. It stands for all students with its program. */
function Robot({ number, count, turn, lane }: RobotProps) {
  if (lane === undefined) return null;
  const { x, y, radius } = lane;
  return (
    <g transform={`translate(${x} ${y}) scale(${radius})`}>
      {count > 1 && <circle r="1" cx="0.3" cy="0.3" />}
      <circle r="1" />
      <path d="M-.46-.4 0-.94 .46-.4z" transform={turn} />
      <text y="0.35">{number}</text>
      {count > 1 && (
        <text className={styles["times"]} x="1.3" y="1.1">
          ×{count}
        </text>
      )}
    </g>
  );
}

interface TrackProps {
  maze: MazeDocument;
  robots: readonly RaceRobot[];
  onClose: () => void;
}

function Track({ maze, robots, onClose }: TrackProps) {
  const { t, i18n } = useTranslation("dashboard", { useSuspense: false });
  const isStill = useMediaQuery("(prefers-reduced-motion: reduce)");
  const [isRunning, setRunning] = useState(!isStill);
  const [tick, setTick] = useState(0);
  const places = useRef<(SVGGElement | null)[]>([]);
  const runs = robots.map(({ run }) => run);
  const end = lastTick(runs);
  const speed = raceSpeed(runs);
  useEffect(() => {
    if (!isRunning) return;
    const draw = (at: number): void => {
      for (const [index, { run }] of robots.entries()) {
        const robot = places.current[index];
        const { place, turn } = transformsOf(poseAt(run, at));
        robot?.setAttribute("transform", place);
        robot?.querySelector("path")?.setAttribute("transform", turn);
      }
    };
    const startedAt = performance.now();
    let request = requestAnimationFrame(function next(now) {
      const at = Math.min(end, Math.max(0, (now - startedAt) / 1000) * TICKS_PER_SECOND * speed);
      draw(at);
      setTick(Math.floor(at / TICKS_PER_TENTH) * TICKS_PER_TENTH);
      if (at < end) request = requestAnimationFrame(next);
      else {
        setTick(end);
        setRunning(false);
      }
    });
    return () => cancelAnimationFrame(request);
  }, [isRunning, robots, end, speed]);
  const { columns, rows } = sizeOf(maze);
  const seconds = (ticks: number): string =>
    t("race.seconds", { seconds: formatSeconds(ticks, i18n.language) });
  const arrived = robots
    .map((robot, at) => ({ ...robot, number: at + 1 }))
    .filter(({ run }) => run.isSolved && run.ticks <= tick)
    .toSorted((a, b) => a.run.ticks - b.run.ticks);
  // Each robot is rendered at its start. Later frames move it past React.
  const starts = robots.map(({ run }) => transformsOf(poseAt(run, 0)));
  const lanes = racePlaces(robots.length);
  return (
    <>
      <div className={styles["bar"]}>
        <p className={styles["clock"]}>
          <span>{seconds(tick)}</span>
          {speed > 1 && <span>{t("race.speed", { speed })}</span>}
          <span>
            {t("race.arrived", { arrived: countRacers(arrived), count: countRacers(robots) })}
          </span>
        </p>
        {!isRunning && (
          <Button
            onClick={() => {
              setTick(0);
              setRunning(true);
            }}
          >
            {tick === 0 ? t("race.start") : t("race.again")}
          </Button>
        )}
        <Button onClick={onClose}>{t("race.close")}</Button>
      </div>
      <svg viewBox={`0 0 ${columns} ${rows}`} aria-hidden="true">
        <MazeDrawing maze={maze} showStart={false} />
        {robots.map(({ run, count }, at) => (
          <g
            key={at}
            ref={(place) => {
              places.current[at] = place;
            }}
            transform={starts[at]?.place}
            className={styles["robot"]}
            data-solved={run.isSolved && run.ticks <= tick}
          >
            <Robot number={at + 1} count={count} turn={starts[at]?.turn} lane={lanes[at]} />
          </g>
        ))}
      </svg>
      <ol className={styles["results"]}>
        {arrived.slice(0, MOST_RESULTS).map(({ number, run, lines, count }) => (
          <li key={number}>
            {t("race.robot", { number })}: {seconds(run.ticks)}, {t("race.lines", { count: lines })}
            {count > 1 && `, ${t("race.times", { count })}`}
          </li>
        ))}
      </ol>
    </>
  );
}
