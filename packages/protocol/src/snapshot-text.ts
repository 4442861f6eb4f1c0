/**
 * Validates snapshots in JSON text without parsing them. A busy relay forwards tens of thousands
 * per second unchanged and needs only their numbers.
 *
 * The regular expression matches a strict subset of JSON: the output of JSON.stringify in ASCII,
 * with the fields in the order of the fixture `page-snapshot.json`, no whitespace, no duplicate
 * fields and no exponents. `snapshot-text.test.ts` checks that `snapshotSchema` accepts every
 * match. Text that does not match may still be valid: the caller passes it to the schema.
 */
import type { Snapshot } from "./snapshot.ts";

/** The numbers of a snapshot, and its place in the text. */
export interface SnapshotSpan {
  seq: number;
  tick: number;
  state: Snapshot["state"];
  /** offsets in the text, `end` excluded; equal to byte offsets, because a match is ASCII */
  start: number;
  end: number;
}

/** At most 15 digits: always a safe integer. */
const COUNT = String.raw`(?:0|[1-9]\d{0,14})`;
const POSITIVE = String.raw`[1-9]\d{0,14}`;
const DECIMALS = String.raw`(?:\.\d{1,23})?`;
/** The integer parts stay below 51,200 and 25,600, so decimals cannot exceed these bounds. */
const READING = String.raw`(?:0|[1-9]\d{0,3}|[1-4]\d{4}|50\d{3}|51[01]\d{2})${DECIMALS}`;
const LENGTH = String.raw`-?(?:0|[1-9]\d{0,3}|1\d{4}|2[0-4]\d{3}|25[0-5]\d{2})${DECIMALS}`;
/** 359.9999999999999999 parses as 360; with at most 12 decimals the value stays below. */
const HEADING = String.raw`(?:(?:0|[1-9]\d?|[12]\d{2}|3[0-4]\d|35[0-8])${DECIMALS}|359(?:\.\d{1,12})?)`;
const TRUTH = "(?:true|false)";
/** Printable ASCII that JSON does not escape. */
const MOTION = String.raw`[ !#-\[\]-~]{0,40}`;

const SNAPSHOT = [
  String.raw`\{"seq":(${COUNT}),"tick":(${COUNT}),"state":"(running|paused|gone)"`,
  String.raw`,"driver":"(?:me|program|remote)"`,
  String.raw`,"sensors":\{"front":${READING},"right":${READING},"back":${READING},"left":${READING}\}`,
  String.raw`,"pose":\{"x":${LENGTH},"y":${LENGTH},"heading":${HEADING}\}`,
  String.raw`,"motion":"${MOTION}","bumps":${COUNT},"bumping":${TRUTH},"goalReached":${TRUTH}`,
  String.raw`,"line":(?:null|"default"|${COUNT}),"command":(?:null|${COUNT})\}`,
].join("");

const here = new RegExp(SNAPSHOT, "y");
const message = new RegExp(
  String.raw`^(\{"type":"snapshot","epoch":(${POSITIVE}),"snapshot":)${SNAPSHOT}\}$`,
);

/** Matches a whole snapshot message of a page. @returns null for any other text, valid or not */
export function findSnapshotMessage(text: string): (SnapshotSpan & { epoch: number }) | null {
  const found = message.exec(text);
  if (found === null) return null;
  const [, before = "", epoch, seq, tick, state] = found;
  return {
    epoch: Number(epoch),
    seq: Number(seq),
    tick: Number(tick),
    state: state as Snapshot["state"],
    start: before.length,
    end: text.length - 1,
  };
}

/** Matches a snapshot at the offset `start`. @returns null for any other text, valid or not */
export function findSnapshot(text: string, start: number): SnapshotSpan | null {
  here.lastIndex = start;
  const found = here.exec(text);
  if (found === null) return null;
  const [, seq, tick, state] = found;
  return {
    seq: Number(seq),
    tick: Number(tick),
    state: state as Snapshot["state"],
    start,
    end: here.lastIndex,
  };
}
