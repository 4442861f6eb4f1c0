/**
 * The project document, `corridor/project` version 1: a maze with a program. A short link stores it;
 * a link contains both documents directly.
 */
import { mazeSchema, type MazeDocument } from "@corridor/maze";
import { programSchema, type ProgramDocument } from "@corridor/program";
import { readJson, type ReadResult } from "@corridor/protocol";
import { z } from "zod";

export const projectSchema = z.strictObject(
  {
    format: z.literal("corridor/project", { error: '"corridor/project"' }),
    version: z.literal(1, { error: "version 1, the newest that this Corridor reads" }),
    maze: mazeSchema,
    program: programSchema,
  },
  { error: "a project: an object" },
);
export type ProjectDocument = z.infer<typeof projectSchema>;

/** Maximum text length in characters: a maze and a program with indentation. */
const MAX_TEXT_LENGTH = 327_680;

/** Returns the project of a maze and a program. */
export function projectOf(maze: MazeDocument, program: ProgramDocument): ProjectDocument {
  return { format: "corridor/project", version: 1, maze, program };
}

/** Reads a project from JSON text. */
export function readProject(text: string): ReadResult<ProjectDocument> {
  return readJson(projectSchema, text, MAX_TEXT_LENGTH);
}
