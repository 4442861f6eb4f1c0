/** The lesson of the benchmark's class: one maze without an end. */
import { taskOf, type LessonDocument } from "@corridor/challenge";
import { generateTree, type MazeDocument } from "@corridor/maze";

/** A tree without a path to its goal, so that no robot stops. */
export function dashboardMaze(): MazeDocument {
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
  const task = taskOf({
    format: "corridor/challenge",
    version: 1,
    name: "Tree",
    words: { task: "Follow the wall.", short: "Follow the wall", hints: [] },
    mazes: [dashboardMaze()],
    program: null,
    goal: { kind: "reach" },
    allowed: {
      drivers: ["program"],
      lines: 3,
      conditions: null,
      actions: null,
      edits: ["condition", "number", "action", "otherwise", "order", "lines"],
      maze: false,
    },
    checks: { bumps: 0, seconds: 600 },
    par: null,
  });
  return {
    format: "corridor/challenge",
    version: 2,
    language: "en",
    name: "Follow the wall",
    intro: "",
    order: "any",
    tasks: [task],
    survey: [],
  };
}
