/**
 * Codes a lesson as bits, with one function for encoding and decoding. The tasks share the models of
 * letters, blocks and numbers, so that each makes the next ones shorter. A maze or a list that
 * repeats an earlier one takes a few bits.
 *
 * A few characters can encode many large mazes. Encoder and decoder therefore limit the length of
 * the mazes' JSON to that of a file.
 */
import {
  helpKinds,
  MAX_CHALLENGE_TEXT_LENGTH,
  MAX_LANGUAGE_LENGTH,
  MAX_QUESTION_LENGTH,
  MAX_SURVEY_QUESTIONS,
  MAX_TASK_LENGTH,
  MAX_TASKS,
  MAX_UNSEEN_SIDE,
  MIN_UNSEEN_SIDE,
  toolNames,
  type LessonDocument,
  type LessonTask,
  type UnseenMazes,
} from "@corridor/challenge";
import { isSameLayout, MAX_NAME_LENGTH, mazeKinds, type MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Choices } from "./choices.ts";
import { LayoutCoder } from "./maze-coder.ts";
import { codeUniform, NumberModel, RealModel } from "./numbers.ts";
import { placeholderTask } from "./placeholders.ts";
import { codeLines } from "./program-coder.ts";
import { BitModel, type BitCoder } from "./range-coder.ts";
import {
  codeBit,
  codeIndices,
  codeOptionalList,
  codeTask,
  type TaskCoders,
  type TaskPart,
} from "./task-coder.ts";
import { TextCoder } from "./text-coder.ts";

/** Maximum length of a question's id. */
const MAX_ID_LENGTH = 32;
/** Number of odd sides. */
const SIDES = (MAX_UNSEEN_SIDE - MIN_UNSEEN_SIDE) / 2 + 1;

/** A part of a lesson: of a task, from 0, or the texts of the lesson itself. */
export interface LessonPart {
  task: number | null;
  part: TaskPart;
}

/**
 * Encodes or decodes a lesson.
 * @param lesson the lesson to encode; a decoder ignores it, and its caller passes any valid one
 * @param onPart called after each part, in order
 * @returns the decoded lesson, not yet checked by its schema; null if it exceeds the bounds of a
 *   lesson, or if the bits cannot come from an encoder
 */
export function codeLesson(
  coder: BitCoder,
  lesson: LessonDocument,
  choices: Choices,
  onPart: (part: LessonPart) => void = () => undefined,
): LessonDocument | null {
  const texts = new TextCoder();
  const codeText = (text: string, max: number): string => texts.code(coder, text, max);
  const isMarked = codeBit(coder, lesson.language !== null);
  const language = isMarked ? codeText(lesson.language ?? "", MAX_LANGUAGE_LENGTH) : null;
  const name = codeText(lesson.name, MAX_NAME_LENGTH);
  const intro = codeText(lesson.intro, MAX_TASK_LENGTH);
  const order = codeBit(coder, lesson.order === "in turn") ? "in turn" : "any";
  const questions = codeUniform(coder, MAX_SURVEY_QUESTIONS + 1, lesson.survey.length);
  const survey = Array.from({ length: questions }, (_, at) => ({
    id: codeText(lesson.survey[at]?.id ?? "", MAX_ID_LENGTH),
    question: codeText(lesson.survey[at]?.question ?? "", MAX_QUESTION_LENGTH),
  }));
  onPart({ task: null, part: "texts" });

  const count = codeUniform(coder, MAX_TASKS, lesson.tasks.length - 1) + 1;
  const coders = new LessonTaskCoder(coder, choices, texts);
  const tasks: LessonTask[] = [];
  for (let at = 0; at < count; at += 1) {
    const task = coders.code(lesson.tasks[at] ?? placeholderTask, (part) => {
      onPart({ task: at, part });
    });
    if (task === null) return null;
    tasks.push(task);
  }
  return { format: "corridor/challenge", version: 2, language, name, intro, order, tasks, survey };
}

/** Contexts of the adaptive bits. */
const SAME_MAZE = 0;
const SAME_LIST = 1;

/** Codes the tasks of one lesson. Each task is predicted from the previous ones. */
class LessonTaskCoder {
  readonly #coder: BitCoder;
  readonly #texts: TextCoder;
  readonly #bits = new BitModel(2, 4);
  readonly #numbers = new NumberModel();
  readonly #reals = new RealModel();
  readonly #seeds = new NumberModel();
  readonly #counts = new NumberModel();
  readonly #mazes: LayoutCoder;
  /** the different mazes so far, without names */
  readonly #layouts: MazeDocument[] = [];
  /** the newest list of each kind of names */
  readonly #lists = new Map<readonly string[], readonly number[]>();
  #remainingJson = MAX_CHALLENGE_TEXT_LENGTH;

  constructor(coder: BitCoder, choices: Choices, texts: TextCoder) {
    this.#coder = coder;
    this.#texts = texts;
    this.#mazes = new LayoutCoder(choices);
  }

  code(task: LessonTask, onPart: (part: TaskPart) => void): LessonTask | null {
    const coder = this.#coder;
    const parts: TaskCoders = {
      numbers: this.#numbers,
      reals: this.#reals,
      text: (text, maxLength) => this.#texts.code(coder, text, maxLength),
      maze: (maze) => this.#codeMaze(maze),
      program: (program) => this.#codeProgram(program),
      indices: (names, chosen) => this.#codeIndices(names, chosen),
      onPart,
    };
    const fields = codeTask(coder, task, parts);
    if (fields === null) return null;
    const tools = codeOptionalList(coder, parts, toolNames, task.allowed.tools);
    const help = codeOptionalList(coder, parts, helpKinds, task.allowed.help);
    const unseen = codeBit(coder, task.unseen !== null) ? this.#codeUnseen(task.unseen) : null;
    return { ...fields, allowed: { ...fields.allowed, tools, help }, unseen };
  }

  #codeMaze(maze: MazeDocument): MazeDocument | null {
    const layout = this.#codeLayout(maze);
    if (layout === null) return null;
    const coded = { ...layout, name: this.#texts.code(this.#coder, maze.name, MAX_NAME_LENGTH) };
    this.#remainingJson -= JSON.stringify(coded).length;
    return this.#remainingJson < 0 ? null : coded;
  }

  #codeLayout(maze: MazeDocument): MazeDocument | null {
    const layouts = this.#layouts;
    const earlier = layouts.findIndex((each) => isSameLayout(each, maze));
    const isSame =
      layouts.length > 0 && this.#bits.code(this.#coder, SAME_MAZE, earlier < 0 ? 0 : 1) === 1;
    if (isSame) return layouts[codeUniform(this.#coder, layouts.length, earlier)] ?? null;
    const layout = this.#mazes.code(this.#coder, maze);
    if (layout !== null) layouts.push(layout);
    return layout;
  }

  #codeProgram(program: ProgramDocument): ProgramDocument | null {
    const lines = codeLines(this.#coder, program);
    if (lines === null) return null;
    return { ...lines, name: this.#texts.code(this.#coder, program.name, MAX_NAME_LENGTH) };
  }

  #codeIndices(names: readonly string[], chosen: readonly number[]): readonly number[] {
    const before = this.#lists.get(names);
    if (before !== undefined) {
      const isSame = before.join() === chosen.join();
      if (this.#bits.code(this.#coder, SAME_LIST, isSame ? 1 : 0) === 1) return before;
    }
    const coded = codeIndices(this.#coder, names.length, chosen);
    this.#lists.set(names, coded);
    return coded;
  }

  #codeUnseen(unseen: UnseenMazes | null): UnseenMazes {
    const { kind, columns, rows, seed, count, pass } = unseen ?? placeholderUnseen;
    const coder = this.#coder;
    const kindAt = codeUniform(coder, mazeKinds.length, mazeKinds.indexOf(kind));
    const codedColumns = codeSide(coder, columns);
    const isSquare = coder.bit(1, 3, columns === rows ? 1 : 0) === 1;
    const codedRows = isSquare ? codedColumns : codeSide(coder, rows);
    const codedSeed = this.#seeds.code(coder, seed);
    const codedCount = this.#counts.code(coder, count);
    return {
      kind: mazeKinds[kindAt] ?? "tree",
      columns: codedColumns,
      rows: codedRows,
      seed: codedSeed,
      count: codedCount,
      // Most lessons accept few failures.
      pass: codedCount - this.#counts.code(coder, count - pass),
    };
  }
}

/** Value that a decoder passes and ignores. */
const placeholderUnseen: UnseenMazes = {
  kind: "tree",
  columns: MIN_UNSEEN_SIDE,
  rows: MIN_UNSEEN_SIDE,
  seed: 0,
  count: 1,
  pass: 1,
};

/** Codes an odd side of an unseen maze. */
function codeSide(coder: BitCoder, side: number): number {
  return MIN_UNSEEN_SIDE + 2 * codeUniform(coder, SIDES, (side - MIN_UNSEEN_SIDE) / 2);
}
