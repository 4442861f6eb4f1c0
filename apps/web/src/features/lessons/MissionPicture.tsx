/**
 * Thumbnail of a mission: its maze, the robot and the idea. Decoration beside the mission's name.
 */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import { ROBOT_RADIUS } from "@corridor/simulation";
import { MazeDrawing } from "../../ui/MazePicture.tsx";
import { ROBOT_BODY } from "../../ui/robot-outline.ts";
import styles from "./mission-picture.module.css";
import type { Idea, Mark, Point } from "../../model/lessons/missions/ideas.ts";

/** Space of a thumbnail in the dialog, in px. Marks have the same size in small and large mazes. */
const ROOM = { width: 144, height: 72 };
const GAP_PX = 8;
const ROBOT_PX = 7;
const BADGE_PX = 16;
const HEAD_PX = 5;
const TICK_PX = 3;
/** Cells between two ticks of a beam. */
const TICK_EVERY = 0.5;

const headings = { north: 0, east: 90, south: 180, west: 270 } as const;

interface MissionPictureProps {
  mazes: readonly MazeDocument[];
  /** one for each displayed maze */
  ideas: readonly Idea[];
}

export function MissionPicture({ mazes, ideas }: MissionPictureProps) {
  const shown = mazes.slice(0, ideas.length);
  const sizes = shown.map(sizeOf);
  const columns = sizes.reduce((sum, size) => sum + size.columns, 0);
  const rows = Math.max(1, ...sizes.map((size) => size.rows));
  const roomWidth = ROOM.width - GAP_PX * (shown.length - 1);
  /** cells per px */
  const px = Math.max(columns / roomWidth, rows / ROOM.height);
  const gap = GAP_PX * px;
  const places = sizes.map((_, at) =>
    sizes.slice(0, at).reduce((x, size) => x + size.columns + gap, 0),
  );
  const width = columns + gap * (shown.length - 1);
  return (
    <svg
      className={styles["picture"]}
      viewBox={`0 0 ${width} ${rows}`}
      preserveAspectRatio="xMidYMid meet"
      aria-hidden="true"
    >
      {shown.map((maze, at) => {
        const top = (rows - (sizes[at]?.rows ?? rows)) / 2;
        return (
          <g key={at} transform={`translate(${places[at]} ${top})`}>
            <MazeDrawing maze={maze} showStart={false} />
            <IdeaMarks maze={maze} idea={ideas[at] ?? { robot: null, marks: [] }} px={px} />
          </g>
        );
      })}
    </svg>
  );
}

function IdeaMarks({ maze, idea, px }: { maze: MazeDocument; idea: Idea; px: number }) {
  const { column, row, heading } = maze.start;
  const at: Point = idea.robot?.at ?? [column + 0.5, row + 0.5];
  const turn = idea.robot?.heading ?? headings[heading];
  const scale = Math.max(0.3, ROBOT_PX * px) / ROBOT_RADIUS;
  const isOver = ({ kind }: Mark) => kind === "badge" || kind === "bump";
  const draw = (mark: Mark, index: number) => <IdeaMark key={index} mark={mark} px={px} />;
  return (
    <>
      {idea.marks.filter((mark) => !isOver(mark)).map(draw)}
      <g transform={`translate(${at[0]} ${at[1]}) rotate(${turn}) scale(${scale})`}>
        <rect className={styles["wheel"]} x={-26} y={-15} width={52} height={30} rx={4.5} />
        <path className={styles["body"]} d={ROBOT_BODY} />
        <rect className={styles["visor"]} x={-15} y={-17} width={30} height={15} rx={7.5} />
        <circle className={styles["eye"]} cx={-7.5} cy={-9.5} r={3.5} />
        <circle className={styles["eye"]} cx={7.5} cy={-9.5} r={3.5} />
      </g>
      {idea.marks.filter(isOver).map(draw)}
    </>
  );
}

function IdeaMark({ mark, px }: { mark: Mark; px: number }) {
  switch (mark.kind) {
    case "path":
      return (
        <g className={styles[mark.isWrong === true ? "wrong" : "way"]}>
          <polyline points={mark.points.join(" ")} />
          <path d={arrowhead(mark.points, HEAD_PX * px)} />
        </g>
      );
    case "beam":
      return <path className={styles["beam"]} d={beamPath(mark.from, mark.to, TICK_PX * px)} />;
    case "badge": {
      const size = BADGE_PX * px;
      const [x, y] = mark.at;
      return (
        <g className={styles["badge"]} data-tone={mark.tone}>
          <rect x={x - size / 2} y={y - size / 2} width={size} height={size} rx={size / 4} />
          <text x={x} y={y + size * 0.26} fontSize={size * 0.72}>
            {mark.text}
          </text>
        </g>
      );
    }
    case "bump": {
      const [x, y] = mark.at;
      const r = HEAD_PX * px;
      return (
        <path
          className={styles["bump"]}
          d={`M${x - r} ${y - r}l${2 * r} ${2 * r}m0 ${-2 * r}l${-2 * r} ${2 * r}`}
        />
      );
    }
  }
}

/** Two strokes at the end of a path, `size` long along each axis. */
function arrowhead(points: readonly Point[], size: number): string {
  const [x, y] = points.at(-1) ?? [0, 0];
  const [fromX, fromY] = points.at(-2) ?? [0, 0];
  // Every path runs along an axis.
  const dx = Math.sign(x - fromX) * size;
  const dy = Math.sign(y - fromY) * size;
  return `M${x - dx - dy} ${y - dy + dx}L${x} ${y}L${x - dx + dy} ${y - dy - dx}`;
}

/** Path along an axis with ticks across it and a longer tick at its end. */
function beamPath(from: Point, to: Point, tick: number): string {
  const dx = Math.sign(to[0] - from[0]);
  const dy = Math.sign(to[1] - from[1]);
  const length = Math.abs(to[0] - from[0]) + Math.abs(to[1] - from[1]);
  let path = `M${from.join(" ")}L${to.join(" ")}`;
  for (let at = length; at > TICK_EVERY; at -= TICK_EVERY) {
    const half = at === length ? 2 * tick : tick;
    const x = from[0] + dx * at;
    const y = from[1] + dy * at;
    path += `M${x - dy * half} ${y - dx * half}L${x + dy * half} ${y + dx * half}`;
  }
  return path;
}
