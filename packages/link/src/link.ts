/**
 * Share links: the fragment of a URL, after `#`. It contains a maze, a program or both, a recorded
 * run, a lesson, or a completion code. Browsers do not send the fragment to a server.
 *
 * A link consists of the version (one character), its length (one), a checksum (four), and the
 * range-coded documents. The decoder rejects a link unless it is valid as a whole. It checks the
 * characters, the length and the checksum first, bounds every size before it allocates memory, and
 * validates the result against the schemas.
 */
import { MAX_LINK_LENGTH, type FieldProblem } from "@corridor/protocol";
import { checkContent } from "./check-content.ts";
import { CHECK_LENGTH, checkOf, digitsOf, textOf } from "./digits.ts";
import { readBody, writeBody, type LinkContent, type MeasuredPart } from "./link-body.ts";
import type { LessonPart } from "./lesson-coder.ts";
import { Decoder, Encoder } from "./range-coder.ts";

/** Reason why content cannot be encoded. */
export type EncodeRefusal =
  /** no content */
  | "empty"
  /** the link would exceed `MAX_LINK_LENGTH`, or the documents the bounds of a link */
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
  | {
      ok: false;
      code: EncodeRefusal;
      problems: FieldProblem[];
      /** the length that the link would have; null if the documents exceed the bounds of a link */
      length: number | null;
      /** the part of a lesson that takes the most characters; null for other content */
      longest: LessonPart | null;
    };

export type DecodeResult =
  | { ok: true; value: LinkContent }
  | { ok: false; code: LinkRefusal; problems: FieldProblem[] };

const VERSION = 1;
/** Length of the header: version, length and checksum. */
const HEADER_LENGTH = 2 + CHECK_LENGTH;
/** The link stores its length modulo this number, in one character. */
const LENGTH_CYCLE = 64;
/**
 * Above this number of missing characters, modulo `LENGTH_CYCLE`, extra characters are more likely.
 */
const MAX_MISSING = 56;

/**
 * Encodes content as a link.
 * @param content valid documents; a run and a completion code exclude other content, a lesson
 *   excludes a maze
 * @returns the text after `#`, which consists of letters, digits, "-" and "_"
 */
export function encodeLink(content: LinkContent): EncodeResult {
  if (Object.values(content).every((each) => each === undefined)) {
    const expected = "a maze, a program or both, a run, a lesson or a completion code";
    return { ...refuse("empty", "nothing", expected), length: null, longest: null };
  }
  const encoder = new Encoder();
  const { isBounded, parts } = writeBody(encoder, content);
  const digits = encoder.finish();
  const cycle = digits.length % LENGTH_CYCLE;
  const text = VERSION + textOf([cycle, ...checkOf(VERSION, [cycle, ...digits]), ...digits]);
  if (isBounded && text.length <= MAX_LINK_LENGTH) return { ok: true, text };
  const longest = longestOf(parts);
  const length = isBounded ? text.length : null;
  const found = length === null ? "more than a link can contain" : `${length} characters`;
  const expected = `at most ${MAX_LINK_LENGTH} characters: ${remedyFor(content, longest)}`;
  return { ...refuse("too-big", found, expected), length, longest };
}

function longestOf([first, ...others]: readonly MeasuredPart[]): LessonPart | null {
  if (first === undefined) return null;
  const { task, part } = others.reduce(
    (most, each) => (each.length > most.length ? each : most),
    first,
  );
  return { task, part };
}

function remedyFor({ run, completion }: LinkContent, longest: LessonPart | null): string {
  if (longest !== null) {
    const { task, part } = longest;
    return `shorten the ${part} of ${task === null ? "the lesson" : `task ${task + 1}`}, or share the file`;
  }
  if (run !== undefined) return "share a shorter run, or its file";
  if (completion !== undefined) return "drive with fewer commands";
  return "share a smaller or simpler maze";
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
      "none of maze, program, run, lesson and completion code",
      "a link of this version",
    );
  }
  if (content === null || decoder.missing() !== 0) {
    return refuse("damaged", "content that is not valid", "a link made by Corridor");
  }
  const checked = checkContent(content);
  return checked.ok ? checked : { ok: false, code: "damaged", problems: checked.problems };
}

function refuse<Code extends string>(
  code: Code,
  found: string,
  expected: string,
): { ok: false; code: Code; problems: FieldProblem[] } {
  return { ok: false, code, problems: [{ path: "link", found, expected }] };
}
