/**
 * Reads what students hand in: a link or a completion code on a line of text, or a file of a
 * program or a run. The page and `grade` use the same readers.
 */
import { lessonMark, type Attempt, type LessonDocument } from "@corridor/challenge";
import { readProgram } from "@corridor/program";
import { describeProblem, problem, type FieldProblem, type ReadResult } from "@corridor/protocol";
import { readRun, type RunDocument } from "@corridor/recording";
import type { CompletionCode } from "./completion-code.ts";
import { readLink, type AddressRefusal } from "./link-address.ts";

export interface HandIn {
  attempt: Attempt;
  /** index of the only task to check, for a completion code; null for all tasks */
  task: number | null;
}

/** Reason why a hand-in is not checked. */
export type HandInRefusal =
  | AddressRefusal
  /** a link without a program, a run or a completion code */
  | "no-program"
  /** a completion code of another lesson */
  | "other-lesson"
  /** a completion code of a task that the lesson does not have */
  | "no-task"
  /** a run that a script drove, or several drivers, or whose maze was edited while driving by hand */
  | "run"
  /** a file that is neither a program nor a run */
  | "document";

export interface RefusedHandIn {
  ok: false;
  code: HandInRefusal;
  /** the problems of a link or a document; the marks of both lessons for "other-lesson" */
  problems: readonly FieldProblem[];
  /** all of it in one English sentence */
  problem: string;
}

export type HandInResult = { ok: true; value: HandIn } | RefusedHandIn;

/** A hand-in on a line of a text. */
export interface HandInLine {
  /** number of the line, from 1 */
  line: number;
  read: HandInResult;
}

/** Maximum number of hand-ins in a text. */
const MAX_HAND_INS = 10_000;

/**
 * Returns the hand-ins of a text, one on each line. Ignores blank lines.
 * @param lesson the lesson that completion codes must belong to
 */
export function handInsOf(text: string, lesson: LessonDocument): ReadResult<HandInLine[]> {
  const lines = text
    .split("\n")
    .map((line, at) => ({ line: at + 1, link: line.trim() }))
    .filter(({ link }) => link !== "");
  if (lines.length > MAX_HAND_INS) {
    return problem("", `${lines.length} lines`, `at most ${MAX_HAND_INS} lines`);
  }
  const target = { mark: lessonMark(lesson), tasks: lesson.tasks.length };
  return {
    ok: true,
    value: lines.map(({ line, link }) => ({ line, read: readHandIn(link, target) })),
  };
}

/** The lesson that codes must belong to. */
interface Target {
  mark: string;
  /** number of tasks */
  tasks: number;
}

/** Reads one link or code. @param text complete address, or the text after `#` */
function readHandIn(text: string, target: Target): HandInResult {
  const read = readLink(text);
  if (!read.ok) return refuse(read.code, read.problems);
  const { completion, program, run } = read.value;
  if (completion !== undefined) return readCode(completion, target);
  if (program !== undefined) return { ok: true, value: { attempt: program, task: null } };
  if (run !== undefined) return handInOfRun(run, "link");
  const expected = "a program or a completion code";
  return refuse("no-program", [{ path: "link", found: "a link without a program", expected }]);
}

function readCode(
  { lesson, task, attempt }: CompletionCode,
  { mark, tasks }: Target,
): HandInResult {
  if (lesson !== mark) {
    const text = "Not checked: this code belongs to another lesson";
    const problems = [{ path: "lesson", found: lesson, expected: mark }];
    return { ok: false, code: "other-lesson", problems, problem: text };
  }
  if (task >= tasks) {
    const text = `Not checked: this code belongs to task ${task + 1}, the lesson has ${tasks}`;
    return { ok: false, code: "no-task", problems: [], problem: text };
  }
  return { ok: true, value: { attempt, task } };
}

/** Reads the text of a file: a program or a run, as Corridor saves it. */
export function readHandInFile(text: string): HandInResult {
  const content = text.replace(/^\uFEFF/, "");
  if (/"format"\s*:\s*"corridor\/run"/.test(content)) {
    const run = readRun(content);
    return run.ok ? handInOfRun(run.value, "inputs") : refuse("document", run.problems);
  }
  const program = readProgram(content);
  return program.ok
    ? { ok: true, value: { attempt: program.value, task: null } }
    : refuse("document", program.problems);
}

function handInOfRun(run: RunDocument, path: string): HandInResult {
  const attempt = attemptOf(run);
  if (attempt !== null) return { ok: true, value: { attempt, task: null } };
  const expected = "a run that a program drives to its end, or that it does not drive at all";
  return refuse("run", [{ path, found: "a run of another or of several drivers", expected }]);
}

/**
 * Returns the program that drives at the end of a run, or the commands of a run that hands and
 * scripts drive alone; null for other runs.
 */
export function attemptOf({ program, inputs }: RunDocument): Attempt | null {
  const drivers = inputs.flatMap((input) =>
    input.do === "driver" ? [{ tick: input.tick, driver: input.driver }] : [],
  );
  const last = drivers.at(-1)?.driver ?? "program";
  if (last === "program") {
    const edits = inputs.flatMap((input) => (input.do === "program" ? [input.program] : []));
    return edits.at(-1) ?? program;
  }
  const first = drivers.findLast(({ tick }) => tick === 0)?.driver ?? "program";
  const hasProgramDriven =
    first === "program" || drivers.some(({ tick, driver }) => tick > 0 && driver === "program");
  if (hasProgramDriven || inputs.some((input) => input.do === "maze")) return null;
  return inputs.flatMap((input) => {
    const { tick } = input;
    if (input.do === "command") return [{ tick, command: input.command }];
    // A canceled command, or the driver again: the robot stops.
    return input.do === "program" ? [] : [{ tick, command: { action: "stop" as const } }];
  });
}

function refuse(code: HandInRefusal, problems: readonly FieldProblem[]): RefusedHandIn {
  return { ok: false, code, problems, problem: problems.map(describeProblem).join("; ") };
}
