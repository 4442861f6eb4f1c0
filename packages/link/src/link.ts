/**
 * Share links: the fragment of a URL, after `#`. It contains a maze, a program or both, a recorded
 * run, or a challenge. Browsers do not send the fragment to a server.
 *
 * A link consists of the version (one character), its length (one), a checksum (four), and the
 * range-coded documents. The decoder rejects a link unless it is valid as a whole. It checks the
 * characters, the length and the checksum first, bounds every size before it allocates memory, and
 * validates the result against the schemas.
 */
import { parseChallenge, type ChallengeDocument } from "@corridor/challenge";
import { parseMaze, type MazeDocument } from "@corridor/maze";
import { parseProgram, type ProgramDocument } from "@corridor/program";
import type { FieldProblem } from "@corridor/protocol";
import { parseRun, type RunDocument } from "@corridor/recording";
import { codeChallenge } from "./challenge-coder.ts";
import { CHECK_LENGTH, checkOf, digitsOf, textOf } from "./digits.ts";
import type { Choices } from "./edit-coder.ts";
import { codeMaze } from "./maze-coder.ts";
import { codeUniform } from "./numbers.ts";
import { codeProgram } from "./program-coder.ts";
import { Decoder, Encoder, type BitCoder } from "./range-coder.ts";
import { codeRun } from "./run-coder.ts";
import { isShorterPlain, shortestBlockMethod } from "./shortest-encoding.ts";

/**
 * Content of a link: a maze, a program or both; a run, which contains a maze and a program; or a
 * challenge, which contains mazes, optionally with the user's program.
 */
export interface LinkContent {
  maze?: MazeDocument;
  program?: ProgramDocument;
  run?: RunDocument;
  challenge?: ChallengeDocument;
}

/** Reason why content cannot be encoded. */
export type EncodeRefusal =
  /** no content */
  | "empty"
  /** the link would exceed `MAX_LINK_LENGTH` */
  | "too-big";

/** Reason why a link cannot be decoded. */
export type LinkRefusal =
  /** no characters after # */
  | "empty"
  /** not a Corridor link, or a link of a newer version */
  | "unknown-version"
  /** the link is shorter than its stored length: most likely its end is missing */
  | "cut-off"
  /** a character is wrong, missing or misplaced */
  | "damaged"
  /** longer than `MAX_LINK_LENGTH` */
  | "too-long";

export type EncodeResult =
  | { ok: true; text: string }
  | { ok: false; code: EncodeRefusal; problems: FieldProblem[] };

export type DecodeResult =
  | { ok: true; value: LinkContent }
  | { ok: false; code: LinkRefusal; problems: FieldProblem[] };

/** Maximum length of a link, in characters. */
export const MAX_LINK_LENGTH = 8_192;

const VERSION = 1;
/** Length of the header: version, length and checksum. */
const HEADER_LENGTH = 2 + CHECK_LENGTH;
/** The link stores its length modulo this number, in one character. */
const LENGTH_CYCLE = 64;
/**
 * Above this number of missing characters, modulo `LENGTH_CYCLE`, extra characters are more likely.
 */
const MAX_MISSING = 56;

/** Number of section codes. A section code follows a header with `isExtended` set. */
const SECTIONS = 16;
const RUN = 0;
const CHALLENGE = 1;

/** Choices of an encoder: the shortest encoding. */
const shortest: Choices = {
  mazeChoicesOf: (maze) => ({
    blockMethod: shortestBlockMethod(maze),
    isPlainName: isShorterPlain(maze.name),
  }),
  isPlainName: isShorterPlain,
};
/** Choices that a decoder passes; it reads the actual ones from the link. */
const noChoices: Choices = {
  mazeChoicesOf: () => ({ blockMethod: 0, isPlainName: false }),
  isPlainName: () => false,
};

/** Documents that a decoder passes to the coding functions, which ignore them. */
const placeholderMaze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["."],
  start: { column: 0, row: 0, heading: "north" },
  goals: [],
};
const placeholderProgram: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "",
  default: "forward",
  rules: [],
};

const placeholderRun: RunDocument = {
  format: "corridor/run",
  version: 1,
  name: "",
  maze: placeholderMaze,
  program: placeholderProgram,
  seed: 0,
  ticks: 0,
  inputs: [],
  digest: "0000000000000000",
};

const placeholderChallenge: ChallengeDocument = {
  format: "corridor/challenge",
  version: 1,
  name: "",
  words: { task: "", short: "", hints: [] },
  mazes: [placeholderMaze],
  program: null,
  goal: { kind: "reach" },
  allowed: { drivers: [], lines: 0, conditions: null, actions: null, edits: [], maze: false },
  checks: { bumps: null, seconds: 1 },
  par: null,
};

/**
 * Encodes content as a link.
 * @param content valid documents; a run excludes other content, a challenge excludes a maze
 * @returns the text after `#`, which consists of letters, digits, "-" and "_"
 */
export function encodeLink({ maze, program, run, challenge }: LinkContent): EncodeResult {
  if ([maze, program, run, challenge].every((each) => each === undefined)) {
    return refuse("empty", "nothing", "a maze, a program or both, a run or a challenge");
  }
  const encoder = new Encoder();
  if (challenge !== undefined) {
    codeHeader(encoder, { isExtended: true, maze: false, program: program !== undefined });
    codeUniform(encoder, SECTIONS, CHALLENGE);
    codeChallenge(encoder, challenge, shortest);
    if (program !== undefined) codeProgram(encoder, program, shortest.isPlainName(program.name));
  } else if (run === undefined) {
    codeHeader(encoder, {
      isExtended: false,
      maze: maze !== undefined,
      program: program !== undefined,
    });
    if (maze !== undefined) codeMaze(encoder, maze, shortest.mazeChoicesOf(maze));
    if (program !== undefined) codeProgram(encoder, program, shortest.isPlainName(program.name));
  } else {
    codeHeader(encoder, { isExtended: true, maze: false, program: false });
    codeUniform(encoder, SECTIONS, RUN);
    if (codeRun(encoder, run, shortest) === null) {
      return refuse("too-big", "a run of very many edits", "a shorter run: share it as a file");
    }
  }
  const digits = encoder.finish();
  const length = digits.length % LENGTH_CYCLE;
  const text = VERSION + textOf([length, ...checkOf(VERSION, [length, ...digits]), ...digits]);
  if (text.length > MAX_LINK_LENGTH) {
    const smaller = run === undefined ? "a smaller or simpler maze" : "a shorter run, or its file";
    const expected = `at most ${MAX_LINK_LENGTH} characters: share ${smaller}`;
    return refuse("too-big", `${text.length} characters`, expected);
  }
  return { ok: true, text };
}

/**
 * Decodes a link.
 * @param text the text after `#`
 * @returns documents equal to those passed to `encodeLink`, or a code and a problem
 */
export function decodeLink(text: string): DecodeResult {
  if (text === "") return refuse("empty", "nothing", "a link");
  if (text.length > MAX_LINK_LENGTH) {
    const expected = `at most ${MAX_LINK_LENGTH} characters`;
    return refuse("too-long", `${text.length} characters`, expected);
  }
  const digits: number[] = [];
  for (const [at, digit] of digitsOf(text.slice(1)).entries()) {
    if (digit === null) {
      const found = `${JSON.stringify(Array.from(text)[at + 1])} as character ${at + 2}`;
      return refuse("damaged", found, "letters, digits, - and _ only");
    }
    digits.push(digit);
  }
  if (text[0] !== String(VERSION)) {
    const found = `a link that begins with ${JSON.stringify(text[0])}`;
    return refuse("unknown-version", found, `one that begins with ${VERSION}`);
  }
  if (text.length <= HEADER_LENGTH) {
    return refuse("cut-off", `${text.length} characters`, `more than ${HEADER_LENGTH}`);
  }
  const [length = 0, ...rest] = digits;
  const body = rest.slice(CHECK_LENGTH);
  const missing = (length - body.length + text.length * LENGTH_CYCLE) % LENGTH_CYCLE;
  if (missing > 0 && missing <= MAX_MISSING) {
    return refuse(
      "cut-off",
      `${text.length} characters`,
      "a complete link: copy it again, to its last character",
    );
  }
  const check = textOf(checkOf(VERSION, [length, ...body]));
  if (missing > 0 || check !== text.slice(2, HEADER_LENGTH)) {
    const found = "wrong or misplaced characters";
    return refuse("damaged", found, "the original link: copy it again");
  }
  const decoder = new Decoder(body);
  const content = readBody(decoder);
  if (content === "unknown") {
    return refuse(
      "unknown-version",
      "none of maze, program, run and challenge",
      "a link of this version",
    );
  }
  if (content === null || decoder.missing() !== 0) {
    return refuse("damaged", "content that is not valid", "a link made by Corridor");
  }
  return checkContent(content);
}

function refuse<Code extends string>(
  code: Code,
  found: string,
  expected: string,
): { ok: false; code: Code; problems: FieldProblem[] } {
  return { ok: false, code, problems: [{ path: "link", found, expected }] };
}

/** Codes which parts follow. If `isExtended` is set, a section code follows instead. */
function codeHeader(
  coder: BitCoder,
  parts: { isExtended: boolean; maze: boolean; program: boolean },
): { isExtended: boolean; maze: boolean; program: boolean } {
  const isExtended = coder.bit(31, 1, parts.isExtended ? 1 : 0) === 1;
  const maze = coder.bit(1, 3, parts.maze ? 1 : 0) === 1;
  const program = coder.bit(1, 1, parts.program ? 1 : 0) === 1;
  return { isExtended, maze, program };
}

function readBody(decoder: Decoder): LinkContent | "unknown" | null {
  const parts = codeHeader(decoder, { isExtended: false, maze: false, program: false });
  if (parts.isExtended) {
    if (parts.maze) return "unknown";
    const section = codeUniform(decoder, SECTIONS, 0);
    if (section === CHALLENGE) return readChallengeSection(decoder, parts.program);
    if (section !== RUN || parts.program) return "unknown";
    const run = codeRun(decoder, placeholderRun, noChoices);
    return run === null ? null : { run };
  }
  if (!parts.maze && !parts.program) return null;
  const content: LinkContent = {};
  if (parts.maze) {
    const maze = codeMaze(decoder, placeholderMaze, noChoices.mazeChoicesOf(placeholderMaze));
    if (maze === null) return null;
    content.maze = maze;
  }
  if (parts.program) {
    const program = codeProgram(decoder, placeholderProgram, false);
    if (program === null) return null;
    content.program = program;
  }
  return content;
}

function readChallengeSection(decoder: Decoder, hasProgram: boolean): LinkContent | null {
  const challenge = codeChallenge(decoder, placeholderChallenge, noChoices);
  if (challenge === null || !hasProgram) return challenge && { challenge };
  const program = codeProgram(decoder, placeholderProgram, false);
  return program && { challenge, program };
}

/** Validates the decoded documents against their schemas. */
function checkContent({ maze, program, run, challenge }: LinkContent): DecodeResult {
  const value: LinkContent = {};
  if (run !== undefined) {
    const read = parseRun(run);
    if (!read.ok)
      return { ok: false, code: "damaged", problems: prefixPaths("run", read.problems) };
    value.run = read.value;
  }
  if (challenge !== undefined) {
    const read = parseChallenge(challenge);
    if (!read.ok) {
      return { ok: false, code: "damaged", problems: prefixPaths("challenge", read.problems) };
    }
    value.challenge = read.value;
  }
  if (maze !== undefined) {
    const read = parseMaze(maze);
    if (!read.ok)
      return { ok: false, code: "damaged", problems: prefixPaths("maze", read.problems) };
    value.maze = read.value;
  }
  if (program !== undefined) {
    const read = parseProgram(program);
    if (!read.ok)
      return { ok: false, code: "damaged", problems: prefixPaths("program", read.problems) };
    value.program = read.value;
  }
  return { ok: true, value };
}

function prefixPaths(part: string, problems: readonly FieldProblem[]): FieldProblem[] {
  return problems.map((each) => ({
    ...each,
    path: each.path === "" ? part : `${part}.${each.path}`,
  }));
}
