/** Equality of mazes, for documents that were copied, such as between threads or by storage. */
import type { MazeDocument } from "./maze-document.ts";

/** Whether two mazes have the same blocks, start and goals. Names may be in another language. */
export function isSameLayout(one: MazeDocument, other: MazeDocument): boolean {
  if (one === other) return true;
  const { start, goals, blocks } = other;
  return (
    one.start.column === start.column &&
    one.start.row === start.row &&
    one.start.heading === start.heading &&
    one.goals.length === goals.length &&
    one.goals.every(
      ({ column, row }, at) => column === goals[at]?.column && row === goals[at].row,
    ) &&
    one.blocks.length === blocks.length &&
    one.blocks.every((row, at) => row === blocks[at])
  );
}

/** The same with equal names. */
export function isSameMaze(one: MazeDocument, other: MazeDocument): boolean {
  return one.name === other.name && isSameLayout(one, other);
}
