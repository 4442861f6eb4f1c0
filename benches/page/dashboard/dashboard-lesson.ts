/** The lesson of the benchmark's class: one maze without an end, and unseen mazes. */
import type { LessonDocument } from "@corridor/challenge";
import { generateTree, type MazeDocument } from "@corridor/maze";
import { benchLesson } from "../bench-lesson.ts";

export const UNSEEN_MAZES = 50;

/** A tree without a path to its goal, so that no robot stops. */
function endlessMaze(): MazeDocument {
  const tree = generateTree({ columns: 11, rows: 7, seed: 1, name: "Round and round" });
  const isBeside = (column: number, row: number): boolean =>
    tree.goals.some((goal) => Math.abs(goal.column - column) + Math.abs(goal.row - row) === 1);
  return {
    ...tree,
    blocks: tree.blocks.map((blocks, row) =>
      Array.from(blocks, (block, column) => (isBeside(column, row) ? "#" : block)).join(""),
    ),
  };
}

export function dashboardLesson(): LessonDocument {
  return benchLesson("Tree", endlessMaze(), {
    kind: "tree",
    columns: 11,
    rows: 11,
    seed: 7,
    count: UNSEEN_MAZES,
    pass: UNSEEN_MAZES,
  });
}
