/**
 * Content of a mission's thumbnail: where the robot stands, and the idea as marks. All positions
 * are in cells from the top-left corner of the maze, so (1.5, 1.5) is the centre of a cell.
 */
import type { MissionId } from "./mission.ts";

export type Point = readonly [x: number, y: number];

export type Mark =
  /** a path of the robot, with an arrowhead at its end; `isWrong` marks the path that fails */
  | { kind: "path"; points: readonly Point[]; isWrong?: true }
  /** a measured distance from the robot to a wall, with ticks */
  | { kind: "beam"; from: Point; to: Point }
  /** the number of a line, or a sign */
  | { kind: "badge"; at: Point; text: string; tone: "rest" | "live" | "bad" | "good" }
  | { kind: "bump"; at: Point };

/** The idea in one maze of the mission. */
export interface Idea {
  /** null: at the start of the maze */
  robot: { at: Point; heading: number } | null;
  marks: readonly Mark[];
}

function idea(...marks: Mark[]): Idea {
  return { robot: null, marks };
}

function withRobot(at: Point, heading: number, ...marks: Mark[]): Idea {
  return { robot: { at, heading }, marks };
}

function path(...points: Point[]): Mark {
  return { kind: "path", points };
}

function wrongPath(...points: Point[]): Mark {
  return { kind: "path", points, isWrong: true };
}

function beam(from: Point, to: Point): Mark {
  return { kind: "beam", from, to };
}

function badge(text: string, at: Point, tone: "rest" | "live" | "bad" | "good" = "rest"): Mark {
  return { kind: "badge", at, text, tone };
}

/** One idea for each maze in the thumbnail of the mission. */
export const ideas: Readonly<Record<MissionId, readonly Idea[]>> = {
  "make-it-move": [idea(path([1.5, 1.5], [4.9, 1.5]))],
  "how-far": [withRobot([5.9, 1.5], 90, beam([5.9, 1.5], [8, 1.5]), badge("?", [7, 0.6], "live"))],
  "one-line": [
    idea(path([3.5, 1.3], [5.5, 1.3], [5.5, 1.7], [2.2, 1.7]), badge("1", [6.5, 0.6], "live")),
  ],
  "first-true-line": [
    idea(
      path([1.5, 3.5], [5.5, 3.5], [5.5, 4.9]),
      badge("2", [1.6, 5.6], "live"),
      badge("1", [3.8, 5.6]),
    ),
  ],
  centimetres: [
    withRobot(
      [5.5, 3.5],
      90,
      beam([5.5, 3.5], [1, 3.5]),
      path([5.5, 3.5], [5.5, 2.2]),
      badge("1", [2.4, 1.6], "live"),
    ),
  ],
  "own-line": [idea(path([1.5, 1.5], [5.5, 1.5], [5.5, 2.9]), badge("+", [2.2, 3.4], "live"))],
  "side-opening": [
    withRobot(
      [3.1, 1.5],
      90,
      path([3.1, 1.5], [3.6, 1.5], [3.6, 2.9]),
      badge("1", [1.6, 3.3], "live"),
    ),
  ],
  "no-room": [
    withRobot(
      [5.45, 3.5],
      90,
      path([5.5, 3.5], [5.5, 2.2]),
      { kind: "bump", at: [6.1, 3.5] },
      badge("1", [2.2, 1.6], "live"),
    ),
  ],
  "order-of-lines": [
    idea(
      wrongPath([1.5, 1.5], [7.3, 1.5]),
      path([4.5, 1.5], [4.5, 2.9]),
      badge("1", [7.4, 3.3]),
      badge("2", [6, 3.3], "live"),
    ),
  ],
  "faulty-line": [
    idea(
      path([2.5, 1.5], [3.5, 1.5], [3.5, 3.5], [5.2, 3.5]),
      { kind: "bump", at: [6, 3.5] },
      badge("3", [1.4, 3.3], "bad"),
    ),
  ],
  "right-wall": [
    idea(path([1.5, 1.5], [3.5, 1.5], [3.5, 3.5], [1.5, 3.5], [1.5, 5.5], [5.5, 5.5], [5.5, 2.2])),
  ],
  "every-maze": [
    idea(path([1.5, 3.5], [5.5, 3.5], [5.5, 1.9])),
    idea(path([1.5, 1.5], [5.5, 1.5], [5.5, 3.1])),
    idea(path([1.5, 1.5], [3.5, 1.5], [3.5, 3.5], [5.1, 3.5]), badge("✓", [7.3, 2.9], "good")),
  ],
  "left-or-right": [
    withRobot([5.5, 3.5], 90, beam([5.5, 3.5], [5.5, 1]), beam([5.5, 3.5], [5.5, 5])),
    withRobot([5.5, 2.5], 90, beam([5.5, 2.5], [5.5, 1]), beam([5.5, 2.5], [5.5, 5])),
  ],
  "farthest-distance": [
    idea(path([1.5, 3.5], [5.5, 3.5], [5.5, 1.5], [6.9, 1.5])),
    idea(path([1.5, 1.5], [5.5, 1.5], [5.5, 3.5], [7.1, 3.5])),
  ],
};
