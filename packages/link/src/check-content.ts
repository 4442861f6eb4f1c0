/** Validates the decoded documents of a link against their schemas. */
import { parseLesson } from "@corridor/challenge";
import { parseMaze } from "@corridor/maze";
import { parseProgram } from "@corridor/program";
import {
  readValue,
  timedCommandsSchema,
  type FieldProblem,
  type ReadResult,
} from "@corridor/protocol";
import { parseRun } from "@corridor/recording";
import type { CompletionCode } from "./completion-code.ts";
import type { LinkContent, UncheckedContent } from "./link-body.ts";

/** @returns the documents, or their problems */
export function checkContent({
  maze,
  program,
  run,
  lesson,
  completion,
}: UncheckedContent): ReadResult<LinkContent> {
  const value: LinkContent = {};
  const problems: FieldProblem[] = [];
  const check = <Part extends keyof LinkContent>(
    part: Part,
    read: ReadResult<NonNullable<LinkContent[Part]>>,
  ): void => {
    if (read.ok) value[part] = read.value;
    else problems.push(...prefixPaths(part, read.problems));
  };
  if (run !== undefined) check("run", parseRun(run));
  if (lesson !== undefined) check("lesson", parseLesson(lesson));
  if (completion !== undefined) check("completion", parseCompletion(completion));
  if (maze !== undefined) check("maze", parseMaze(maze));
  if (program !== undefined) check("program", parseProgram(program));
  return problems.length === 0 ? { ok: true, value } : { ok: false, problems };
}

function parseCompletion(code: CompletionCode): ReadResult<CompletionCode> {
  const { attempt } = code;
  const read = "rules" in attempt ? parseProgram(attempt) : readValue(timedCommandsSchema, attempt);
  return read.ok ? { ok: true, value: { ...code, attempt: read.value } } : read;
}

function prefixPaths(part: string, problems: readonly FieldProblem[]): FieldProblem[] {
  return problems.map((each) => ({
    ...each,
    path: each.path === "" ? part : `${part}.${each.path}`,
  }));
}
