/** A lesson of one task, as the benchmarks of checks and of the dashboard use it. */
import { taskOf, type LessonDocument, type LessonTask } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";

export function benchLesson(
  name: string,
  maze: MazeDocument,
  unseen: LessonTask["unseen"] = null,
): LessonDocument {
  const task = taskOf({
    format: "corridor/challenge",
    version: 1,
    name,
    words: { task: "Reach the goal.", short: "Reach the goal", hints: [] },
    mazes: [maze],
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
    name,
    intro: "",
    order: "any",
    tasks: [{ ...task, unseen }],
    survey: [],
  };
}
