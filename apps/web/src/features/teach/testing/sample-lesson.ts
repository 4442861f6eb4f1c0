/** A lesson of two tasks, and hand-ins that pass or fail them. */
import { lessonOfTasks, taskIn } from "@corridor/challenge/testing";
import { encodeLink } from "@corridor/link";
import { mazePresets, type MazePresetId } from "@corridor/maze";
import { programPresets, type ProgramDocument, type ProgramPresetId } from "@corridor/program";

export function mazeOf(id: MazePresetId) {
  const preset = mazePresets.find((each) => each.id === id);
  if (preset === undefined) throw new Error(`no maze ${id}`);
  return preset.maze;
}

export function programOf(id: ProgramPresetId, name: string): ProgramDocument {
  const preset = programPresets.find((each) => each.id === id);
  if (preset === undefined) throw new Error(`no program ${id}`);
  return { ...preset.program, name };
}

export function linkOf(program: ProgramDocument): string {
  const link = encodeLink({ program });
  if (!link.ok) throw new Error(link.code);
  return link.text;
}

/** Right-wall passes; left-wall bumps in maze 2; back-and-forth is too slow. */
export const sampleTask = taskIn([mazeOf("first-steps"), mazeOf("comb")], {
  name: "Two mazes",
  unseen: { kind: "tree", columns: 7, rows: 7, seed: 7, count: 5, pass: 4 },
});

export const sampleLesson = lessonOfTasks("Two tasks", [
  sampleTask,
  { ...sampleTask, name: "One maze", unseen: null },
]);
