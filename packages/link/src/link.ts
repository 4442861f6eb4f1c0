/**
 * Share links: what follows `#` in the URL. A maze, a program or both, a recorded run or a challenge
 * travel inside the link itself, so they need no server and reach none.
 *
 * A link is the version (one character), its length (one), a check (four), and the documents through a
 * range coder. It is read in full or refused: characters, length and check are looked at before anything
 * is built, every size is bounded before memory is taken, and the result passes its schemas.
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
import { isShorterPlain, shortestBlockWay } from "./shortest-way.ts";

/**
 * What a link carries: a maze, a program or both; or a run, which has its own; or a challenge, which
 * has its mazes, alone or with the program of who shares it.
 */
export interface LinkContent {
  maze?: MazeDocument;
  program?: ProgramDocument;
  run?: RunDocument;
  challenge?: ChallengeDocument;
}

/** Why there is no link for a content. */
export type EncodeRefusal =
  /** nothing was given */
  | "empty"
  /** the link would be longer than any reader takes; a smaller or simpler maze, or a shorter run fits */
  | "too-big";

/** Why a link cannot be read. */
export type LinkRefusal =
  /** there is nothing behind the # */
  | "empty"
  /** it is no Corridor link, or one of a newer Corridor */
  | "unknown-version"
  /** its length is not the one that it tells: most likely its end is missing */
  | "cut-off"
  /** a character is wrong, missing or in another place */
  | "damaged"
  /** it is longer than 8,192 characters */
  | "too-long";

export type EncodeResult =
  | { ok: true; text: string }
  | { ok: false; code: EncodeRefusal; problems: FieldProblem[] };

export type DecodeResult =
  | { ok: true; value: LinkContent }
  | { ok: false; code: LinkRefusal; problems: FieldProblem[] };

/** Longest link that is written or read, in characters. */
export const MAX_LINK_LENGTH = 8_192;

const VERSION = 1;
/** Version, length and check stand in front of the documents. */
const HEAD_LENGTH = 2 + CHECK_LENGTH;
/** The length is told modulo this, in one character. */
const LENGTH_CYCLE = 64;
/** A link that would lack more than this has more likely a few characters too many. */
const MAX_LACKING = 56;

/** Behind a head with `more` set stands what follows, one of so many. */
const SECTIONS = 16;
const RUN = 0;
const CHALLENGE = 1;

/** What an encoder chooses: whatever takes the fewest characters. */
const shortest: Choices = {
  waysOf: (maze) => ({
    blocks: shortestBlockWay(maze),
    isPlainName: isShorterPlain(maze.name),
  }),
  isPlainName: isShorterPlain,
};
/** A decoder finds them in the link. */
const none: Choices = {
  waysOf: () => ({ blocks: 0, isPlainName: false }),
  isPlainName: () => false,
};

/** What a decoder hands to the functions that also write; none of it is read. */
const anyMaze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["."],
  start: { column: 0, row: 0, heading: "north" },
  goals: [],
};
const anyProgram: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "",
  default: "forward",
  rules: [],
};

const anyRun: RunDocument = {
  format: "corridor/run",
  version: 1,
  name: "",
  maze: anyMaze,
  program: anyProgram,
  seed: 0,
  ticks: 0,
  inputs: [],
  digest: "0000000000000000",
};

const anyChallenge: ChallengeDocument = {
  format: "corridor/challenge",
  version: 1,
  name: "",
  words: { task: "", short: "", hints: [] },
  mazes: [anyMaze],
  program: null,
  goal: { kind: "reach" },
  allowed: { drivers: [], lines: 0, conditions: null, actions: null, edits: [], maze: false },
  checks: { bumps: null, seconds: 1 },
  par: null,
};

/**
 * The text of a link.
 * @param content documents that passed their schemas; a run goes alone, a challenge without a maze
 * @returns what follows `#`: letters, digits, "-" and "_"
 */
export function encodeLink({ maze, program, run, challenge }: LinkContent): EncodeResult {
  if ([maze, program, run, challenge].every((each) => each === undefined)) {
    return refuse("empty", "nothing", "a maze, a program or both, a run or a challenge");
  }
  const encoder = new Encoder();
  if (challenge !== undefined) {
    codeHead(encoder, { more: true, maze: false, program: program !== undefined });
    codeUniform(encoder, SECTIONS, CHALLENGE);
    codeChallenge(encoder, challenge, shortest);
    if (program !== undefined) codeProgram(encoder, program, shortest.isPlainName(program.name));
  } else if (run === undefined) {
    codeHead(encoder, { more: false, maze: maze !== undefined, program: program !== undefined });
    if (maze !== undefined) codeMaze(encoder, maze, shortest.waysOf(maze));
    if (program !== undefined) codeProgram(encoder, program, shortest.isPlainName(program.name));
  } else {
    codeHead(encoder, { more: true, maze: false, program: false });
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
 * Reads what follows `#`.
 * @returns the documents exactly as they were given to `encodeLink`; or a code, and the problem in words
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
  if (text.length <= HEAD_LENGTH) {
    return refuse("cut-off", `${text.length} characters`, `more than ${HEAD_LENGTH}`);
  }
  const [length = 0, ...rest] = digits;
  const body = rest.slice(CHECK_LENGTH);
  const lacking = (length - body.length + text.length * LENGTH_CYCLE) % LENGTH_CYCLE;
  if (lacking > 0 && lacking <= MAX_LACKING) {
    return refuse(
      "cut-off",
      `${text.length} characters`,
      "another number: copy it again, to its last character",
    );
  }
  const check = textOf(checkOf(VERSION, [length, ...body]));
  if (lacking > 0 || check !== text.slice(2, HEAD_LENGTH)) {
    const found = "characters that are wrong or not in their places";
    return refuse("damaged", found, "the link as it was made: copy it again");
  }
  const decoder = new Decoder(body);
  const content = readBody(decoder);
  if (content === "more") {
    return refuse(
      "unknown-version",
      "none of maze, program, run and challenge",
      "a link of this version",
    );
  }
  if (content === null || decoder.missing() !== 0) {
    return refuse("damaged", "what no Corridor writes", "a link made by Corridor");
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

/** Which parts follow. `more` says that it is something else, whose section comes next. */
function codeHead(
  coder: BitCoder,
  parts: { more: boolean; maze: boolean; program: boolean },
): { more: boolean; maze: boolean; program: boolean } {
  const more = coder.bit(31, 1, parts.more ? 1 : 0) === 1;
  const maze = coder.bit(1, 3, parts.maze ? 1 : 0) === 1;
  const program = coder.bit(1, 1, parts.program ? 1 : 0) === 1;
  return { more, maze, program };
}

function readBody(decoder: Decoder): LinkContent | "more" | null {
  const parts = codeHead(decoder, { more: false, maze: false, program: false });
  if (parts.more) {
    if (parts.maze) return "more";
    const section = codeUniform(decoder, SECTIONS, 0);
    if (section === CHALLENGE) return readChallengeSection(decoder, parts.program);
    if (section !== RUN || parts.program) return "more";
    const run = codeRun(decoder, anyRun, none);
    return run === null ? null : { run };
  }
  if (!parts.maze && !parts.program) return null;
  const content: LinkContent = {};
  if (parts.maze) {
    const maze = codeMaze(decoder, anyMaze, none.waysOf(anyMaze));
    if (maze === null) return null;
    content.maze = maze;
  }
  if (parts.program) {
    const program = codeProgram(decoder, anyProgram, false);
    if (program === null) return null;
    content.program = program;
  }
  return content;
}

function readChallengeSection(decoder: Decoder, hasProgram: boolean): LinkContent | null {
  const challenge = codeChallenge(decoder, anyChallenge, none);
  if (challenge === null || !hasProgram) return challenge && { challenge };
  const program = codeProgram(decoder, anyProgram, false);
  return program && { challenge, program };
}

/** The schemas have the last word, whatever a link says. */
function checkContent({ maze, program, run, challenge }: LinkContent): DecodeResult {
  const value: LinkContent = {};
  if (run !== undefined) {
    const read = parseRun(run);
    if (!read.ok) return { ok: false, code: "damaged", problems: inside("run", read.problems) };
    value.run = read.value;
  }
  if (challenge !== undefined) {
    const read = parseChallenge(challenge);
    if (!read.ok) {
      return { ok: false, code: "damaged", problems: inside("challenge", read.problems) };
    }
    value.challenge = read.value;
  }
  if (maze !== undefined) {
    const read = parseMaze(maze);
    if (!read.ok) return { ok: false, code: "damaged", problems: inside("maze", read.problems) };
    value.maze = read.value;
  }
  if (program !== undefined) {
    const read = parseProgram(program);
    if (!read.ok) return { ok: false, code: "damaged", problems: inside("program", read.problems) };
    value.program = read.value;
  }
  return { ok: true, value };
}

function inside(part: string, problems: readonly FieldProblem[]): FieldProblem[] {
  return problems.map((each) => ({
    ...each,
    path: each.path === "" ? part : `${part}.${each.path}`,
  }));
}
