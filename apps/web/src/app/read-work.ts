/**
 * Reads one stored work. A file of its own, because the schemas that it needs are a fifth of the
 * page: they come before the page opens only where something is stored.
 */
import { parseMaze } from "@corridor/maze";
import { parseProgram } from "@corridor/program";
import { describeProblem, type FieldProblem } from "@corridor/protocol";
import type { ReadWork } from "./works.ts";

/** @param id the one in the entry's key, which wins: a copied entry is its own work */
export const readWork: ReadWork = (text, id) => {
  let input: unknown;
  try {
    input = JSON.parse(text);
  } catch {
    return refusal("", [{ path: "", found: "unreadable text", expected: "a JSON document" }]);
  }
  if (typeof input !== "object" || input === null) {
    return refusal("", [{ path: "", found: "no object", expected: "a saved work" }]);
  }
  const { savedAt, revision, edited, maze, program } = input as Record<string, unknown>;
  const readMaze = parseMaze(maze);
  if (!readMaze.ok) return refusal("maze", readMaze.problems);
  const readProgram = parseProgram(program);
  if (!readProgram.ok) return refusal("program", readProgram.problems);
  return {
    ok: true,
    value: {
      id,
      // The documents are the work. The rest has a harmless reading whatever stands there.
      savedAt: typeof savedAt === "number" && Number.isFinite(savedAt) ? savedAt : 0,
      revision: typeof revision === "string" ? revision : "",
      edited: edited !== false,
      maze: readMaze.value,
      program: readProgram.value,
    },
  };
};

function refusal(field: string, problems: FieldProblem[]): { ok: false; reason: string } {
  const inField = problems.map((each) => ({
    ...each,
    path: [field, each.path].filter((part) => part !== "").join("."),
  }));
  return { ok: false, reason: inField.map(describeProblem).join("; ") };
}
