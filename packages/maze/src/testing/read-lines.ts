/** Reads a maze that is written as text, for tables of tests. */
import { readTextMaze } from "../text-maze.ts";

/** @returns its rows, its start and its goals, each as a text; or its problems */
export function readLines(...lines: string[]): string[] {
  const result = readTextMaze(lines.join("\n"), "Read");
  if (!result.ok) {
    return result.problems.map((each) => `${each.path}: ${each.found}, ${each.expected}`);
  }
  const { blocks, start, goals } = result.value;
  const to = goals.map(({ column, row }) => `${column},${row}`);
  return [...blocks, `${start.column},${start.row} ${start.heading}`, ...to];
}
