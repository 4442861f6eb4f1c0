/** The stage as SVG, rendered by React in every frame. Only the last piece of the trail changes. */
import { isBlock, sizeOf, type MazeDocument } from "@corridor/maze";
import { sensorNames } from "@corridor/protocol";
import { createElement, memo } from "react";
import { STAGE_PX, type RunFrame } from "./bench-run.ts";

const CELL = 100;
const PIECE_POINTS = 100;

const Walls = memo(function Walls({ maze }: { maze: MazeDocument }) {
  const { columns, rows } = sizeOf(maze);
  let path = "";
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      if (isBlock(maze, column, row)) path += `M${column * CELL} ${row * CELL}h100v100h-100z`;
    }
  }
  return createElement("path", { d: path, fill: "#c5ced8" });
});

const Piece = memo(function Piece({ points }: { points: string }) {
  return createElement("polyline", { points, fill: "none", stroke: "#f7c6a2", strokeWidth: 8 });
});

interface SvgStageProps {
  maze: MazeDocument;
  /** the trail in pieces of about 100 points; only the last piece changes */
  pieces: readonly string[];
  frame: RunFrame;
}

/** The trail as values of the `points` attribute. */
export class TrailPieces {
  #pieces: string[];
  #count = 0;

  /** @param trail alternating x and y */
  constructor(trail: readonly number[]) {
    this.#pieces = Array.from({ length: Math.ceil(trail.length / (2 * PIECE_POINTS)) }, (_, at) =>
      trail.slice(2 * PIECE_POINTS * at, 2 * PIECE_POINTS * (at + 1) + 2).join(" "),
    );
  }

  /** Appends the robot's position. @returns a new list of all pieces */
  append({ pose }: RunFrame): readonly string[] {
    const point = `${pose.x},${pose.y}`;
    if (this.#count++ % PIECE_POINTS === 0) this.#pieces.push(point);
    else this.#pieces.push(`${this.#pieces.pop()} ${point}`);
    return [...this.#pieces];
  }
}

export function SvgStage({ maze, pieces, frame }: SvgStageProps) {
  const { columns } = sizeOf(maze);
  const { x, y, heading } = frame.pose;
  return createElement(
    "svg",
    { width: STAGE_PX, height: STAGE_PX, viewBox: `0 0 ${columns * CELL} ${columns * CELL}` },
    createElement(Walls, { maze }),
    pieces.map((points, at) => createElement(Piece, { key: at, points })),
    sensorNames.map((sensor, at) => {
      const radians = ((heading + 90 * at) * Math.PI) / 180;
      const toX = x + Math.sin(radians) * frame.sensors[sensor];
      const toY = y - Math.cos(radians) * frame.sensors[sensor];
      return createElement(
        "g",
        { key: sensor },
        createElement("line", {
          x1: x,
          y1: y,
          x2: toX,
          y2: toY,
          stroke: "#c8692f",
          strokeWidth: 3,
        }),
        createElement("text", { x: toX, y: toY, fontSize: 45 }, Math.round(frame.sensors[sensor])),
      );
    }),
    createElement("circle", { cx: x, cy: y, r: 25, fill: "#ef6a1a" }),
  );
}
