/** A task in one maze that allows every program. */
import { lessonOf, type ChallengeDocument, type LessonTask } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";

export function taskIn(
  maze: MazeDocument,
  seconds: number,
): { document: ChallengeDocument; task: LessonTask } {
  const document: ChallengeDocument = {
    format: "corridor/challenge",
    version: 1,
    name: "Tree",
    words: { task: "", short: "", hints: [] },
    mazes: [maze],
    program: null,
    goal: { kind: "reach" },
    allowed: {
      drivers: ["program"],
      lines: 200,
      conditions: null,
      actions: null,
      edits: ["condition", "number", "action", "otherwise", "order", "lines"],
      maze: false,
    },
    checks: { bumps: null, seconds },
    par: null,
  };
  const [task] = lessonOf(document).tasks;
  if (task === undefined) throw new Error("the lesson has no task");
  return { document, task };
}
