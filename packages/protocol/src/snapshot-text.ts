/**
 * A snapshot recognised in a text, without making an object of it. At a busy relay tens of thousands a second go
 * by, and nearly all of them only go by: it needs their numbers, and must know that the rest is right.
 *
 * What is recognised is a snapshot as JSON.stringify writes it, in ASCII, its fields in the order of the
 * fixture `page-snapshot.json`, nothing between them, nothing twice, no number in the form of 1e5. So every reader
 * of JSON understands it alike, and `snapshotSchema` takes it, too: `snapshot-text.test.ts` holds it to that.
 * Whatever else there is need not be wrong; it goes to the schema, which has the words of every refusal.
 */
import type { Snapshot } from "./snapshot.ts";

/** What is known of a snapshot that was not read further. */
export interface SnapshotPlace {
  seq: number;
  tick: number;
  state: Snapshot["state"];
  /** where it begins and ends in the text; all of it is ASCII, so its bytes are as many */
  start: number;
  end: number;
}

/** So many digits are always a safe integer. */
const COUNT = String.raw`(?:0|[1-9]\d{0,14})`;
const POSITIVE = String.raw`[1-9]\d{0,14}`;
const DECIMALS = String.raw`(?:\.\d{1,23})?`;
/** Below 51,200 and 25,600: what follows the point leads no farther than there, which is allowed. */
const READING = String.raw`(?:0|[1-9]\d{0,3}|[1-4]\d{4}|50\d{3}|51[01]\d{2})${DECIMALS}`;
const LENGTH = String.raw`-?(?:0|[1-9]\d{0,3}|1\d{4}|2[0-4]\d{3}|25[0-5]\d{2})${DECIMALS}`;
/** 359.9999999999999999 is 360 to whoever reads it; with 12 digits behind the point it is not. */
const HEADING = String.raw`(?:(?:0|[1-9]\d?|[12]\d{2}|3[0-4]\d|35[0-8])${DECIMALS}|359(?:\.\d{1,12})?)`;
const TRUTH = "(?:true|false)";
/** Printable, and nothing that JSON would have to escape. */
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

/** A page's snapshot message, all of it. @returns null for all else, which need not be wrong */
export function findSnapshotMessage(text: string): (SnapshotPlace & { epoch: number }) | null {
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

/** A snapshot that begins at that place. @returns null for all else, which need not be wrong */
export function findSnapshot(text: string, start: number): SnapshotPlace | null {
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
