/**
 * Parses one stored project. In its own file, because the schemas are a fifth of the page: they
 * load before the page opens only if something is stored.
 */
import { parseMaze } from "@corridor/maze";
import { parseProgram } from "@corridor/program";
import { describeProblem, type FieldProblem } from "@corridor/protocol";
import type { ReadProject } from "./project-storage.ts";

/**
 * @param id the id in the entry's key, which takes precedence: a copied entry is its own project
 */
export const readProject: ReadProject = (text, id) => {
  let input: unknown;
  try {
    input = JSON.parse(text);
  } catch {
    return refusal("", [{ path: "", found: "unreadable text", expected: "a JSON document" }]);
  }
  if (typeof input !== "object" || input === null) {
    return refusal("", [{ path: "", found: "no object", expected: "a saved project" }]);
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
      // Only the documents must be valid. The other fields have harmless defaults.
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
