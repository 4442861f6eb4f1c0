/**
 * Codes the content of a link as bits: a header that names the documents, then the documents. A
 * header with `isExtended` set is followed by the number of a section, which is a run, a challenge,
 * a lesson or a completion code.
 */
import { oldestDocumentOf, type ChallengeDocument, type LessonDocument } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { RunDocument } from "@corridor/recording";
import { codeChallenge } from "./challenge-coder.ts";
import { noChoices } from "./choices.ts";
import type { CompletionCode } from "./completion-code.ts";
import { codeCompletion } from "./completion-coder.ts";
import { codeLesson, type LessonPart } from "./lesson-coder.ts";
import { codeMaze } from "./maze-coder.ts";
import { codeUniform } from "./numbers.ts";
import {
  placeholderCode,
  placeholderLesson,
  placeholderMaze,
  placeholderProgram,
  placeholderRun,
  placeholderTask,
} from "./placeholders.ts";
import { codeProgram } from "./program-coder.ts";
import type { BitCoder, Decoder, Encoder } from "./range-coder.ts";
import { codeRun } from "./run-coder.ts";
import { shortest } from "./shortest-encoding.ts";

/**
 * Content of a link: a maze, a program or both; a run, which contains a maze and a program; a
 * lesson, optionally with the user's program; or a completion code.
 */
export interface LinkContent {
  maze?: MazeDocument;
  program?: ProgramDocument;
  run?: RunDocument;
  /** a challenge document of version 1 is a lesson of one task */
  lesson?: LessonDocument;
  completion?: CompletionCode;
}

/** Decoded content whose documents are not yet checked by their schemas. */
export interface UncheckedContent {
  maze?: unknown;
  program?: unknown;
  run?: unknown;
  /** of either version */
  lesson?: unknown;
  completion?: CompletionCode;
}

/** Number of section numbers. */
const SECTIONS = 16;
const RUN = 0;
const CHALLENGE = 1;
const LESSON = 2;
const COMPLETION = 3;

interface Header {
  isExtended: boolean;
  maze: boolean;
  program: boolean;
}

/** Length of a part of a lesson, in digits. */
export interface MeasuredPart extends LessonPart {
  length: number;
}

/**
 * Encodes the content.
 * @returns whether the content is within the bounds of a link apart from its length, and the
 *   lengths of a lesson's parts
 */
export function writeBody(
  encoder: Encoder,
  { maze, program, run, lesson, completion }: LinkContent,
): { isBounded: boolean; parts: readonly MeasuredPart[] } {
  if (lesson !== undefined) return writeLesson(encoder, lesson, program);
  if (completion !== undefined) {
    codeSection(encoder, COMPLETION, false);
    return { isBounded: codeCompletion(encoder, completion) !== null, parts: [] };
  }
  if (run !== undefined) {
    codeSection(encoder, RUN, false);
    return { isBounded: codeRun(encoder, run, shortest) !== null, parts: [] };
  }
  const header = { isExtended: false, maze: maze !== undefined, program: program !== undefined };
  codeHeader(encoder, header);
  if (maze !== undefined) codeMaze(encoder, maze, shortest);
  if (program !== undefined) codeProgram(encoder, program, shortest.isPlainName(program.name));
  return { isBounded: true, parts: [] };
}

function writeLesson(
  encoder: Encoder,
  lesson: LessonDocument,
  program: ProgramDocument | undefined,
): ReturnType<typeof writeBody> {
  const parts: MeasuredPart[] = [];
  let before = 0;
  const onPart = (part: LessonPart): void => {
    parts.push({ ...part, length: encoder.length - before });
    before = encoder.length;
  };
  // Older pages read challenges only.
  const document = oldestDocumentOf(lesson);
  codeSection(encoder, document.version === 1 ? CHALLENGE : LESSON, program !== undefined);
  const coded =
    document.version === 1
      ? codeChallenge(encoder, document, shortest, (part) => onPart({ task: 0, part }))
      : codeLesson(encoder, document, shortest, onPart);
  if (program !== undefined) codeProgram(encoder, program, shortest.isPlainName(program.name));
  return { isBounded: coded !== null, parts };
}

/**
 * Decodes the content.
 * @returns documents not yet checked by their schemas; "unknown" for content of a newer version;
 *   null if the bits cannot come from an encoder
 */
export function readBody(decoder: Decoder): UncheckedContent | "unknown" | null {
  const header = codeHeader(decoder, { isExtended: false, maze: false, program: false });
  if (header.isExtended) {
    return header.maze ? "unknown" : readSection(decoder, header.program);
  }
  if (!header.maze && !header.program) return null;
  const content: UncheckedContent = {};
  if (header.maze) {
    const maze = codeMaze(decoder, placeholderMaze, noChoices);
    if (maze === null) return null;
    content.maze = maze;
  }
  return header.program ? withProgram(decoder, content) : content;
}

function readSection(decoder: Decoder, hasProgram: boolean): UncheckedContent | "unknown" | null {
  const section = codeUniform(decoder, SECTIONS, 0);
  if (section === CHALLENGE || section === LESSON) {
    const lesson =
      section === LESSON
        ? codeLesson(decoder, placeholderLesson, noChoices)
        : readChallenge(decoder);
    if (lesson === null || !hasProgram) return lesson && { lesson };
    return withProgram(decoder, { lesson });
  }
  if (hasProgram) return "unknown";
  if (section === RUN) {
    const run = codeRun(decoder, placeholderRun, noChoices);
    return run && { run };
  }
  if (section !== COMPLETION) return "unknown";
  const completion = codeCompletion(decoder, placeholderCode);
  return completion && { completion };
}

function readChallenge(decoder: Decoder): ChallengeDocument | null {
  const fields = codeChallenge(decoder, placeholderTask, noChoices);
  return fields && { format: "corridor/challenge", version: 1, ...fields };
}

function withProgram(decoder: Decoder, content: UncheckedContent): UncheckedContent | null {
  const program = codeProgram(decoder, placeholderProgram, false);
  return program && { ...content, program };
}

/** Codes which documents follow. If `isExtended` is set, the number of a section follows instead. */
function codeHeader(coder: BitCoder, header: Header): Header {
  const isExtended = coder.bit(31, 1, header.isExtended ? 1 : 0) === 1;
  const maze = coder.bit(1, 3, header.maze ? 1 : 0) === 1;
  const program = coder.bit(1, 1, header.program ? 1 : 0) === 1;
  return { isExtended, maze, program };
}

function codeSection(encoder: Encoder, section: number, hasProgram: boolean): void {
  codeHeader(encoder, { isExtended: true, maze: false, program: hasProgram });
  codeUniform(encoder, SECTIONS, section);
}
