/**
 * Reading what a page says. Nearly all of it are snapshots, tens of thousands a second at a busy relay, and
 * for these a check by hand comes first. It takes only what the schema takes too, which
 * `page-frame.test.ts` holds it to; whatever it does not know goes to the schema, which has the last word
 * and the words of every refusal.
 */
import { decodeFrame, MAX_FRAME_BYTES } from "./codec.ts";
import type { ReadResult } from "./document-reader.ts";
import { pageToRelaySchema, type PageToRelay } from "./messages.ts";
import { MAX_LENGTH } from "./quantities.ts";
import type { Snapshot } from "./snapshot.ts";

type SnapshotMessage = Extract<PageToRelay, { type: "snapshot" }>;

/**
 * Fields of a snapshot message, inner ones too. A text that has each of them and as many colons has no other
 * field, none twice and no colon in a text.
 */
const FIELDS = 22;

/** Reads a message of a page that has said hello and resume. */
export function decodePageFrame(text: string): ReadResult<PageToRelay> {
  const snapshot = readPlainSnapshot(text);
  if (snapshot !== null) return { ok: true, value: snapshot };
  return decodeFrame(pageToRelaySchema, text);
}

/** A snapshot without anything unusual; null for all else, which need not be wrong. */
export function readPlainSnapshot(text: string): SnapshotMessage | null {
  if (text.length > MAX_FRAME_BYTES || !text.startsWith('{"type":"snapshot"')) return null;
  if (!hasColons(text, FIELDS)) return null;
  let message: unknown;
  try {
    message = JSON.parse(text);
  } catch {
    return null;
  }
  return isSnapshotMessage(message) ? message : null;
}

function hasColons(text: string, wanted: number): boolean {
  let count = 0;
  for (let at = text.indexOf(":"); at >= 0; at = text.indexOf(":", at + 1)) count += 1;
  return count === wanted;
}

/** A value of which nothing is known; a field that is missing is undefined. */
type Loose<T> = { readonly [name in keyof T]?: unknown } | null | undefined;

function isSnapshotMessage(input: unknown): input is SnapshotMessage {
  const message = input as Loose<SnapshotMessage>;
  if (typeof message !== "object" || message === null) return false;
  if (message.type !== "snapshot" || !isCount(message.epoch) || message.epoch < 1) return false;
  return isSnapshot(message.snapshot);
}

/** A snapshot by itself, as one relay tells it to another; a false one need not be wrong. */
export function isPlainSnapshot(input: unknown): input is Snapshot {
  return (
    isSnapshot(input) &&
    hasFields(input, 12) &&
    hasFields(input.sensors, 4) &&
    hasFields(input.pose, 3)
  );
}

function hasFields(input: object, wanted: number): boolean {
  return Object.keys(input).length === wanted;
}

/** Whether all fields are there and right; there may be others. */
function isSnapshot(input: unknown): input is Snapshot {
  const snapshot = input as Loose<Snapshot>;
  if (typeof snapshot !== "object" || snapshot === null) return false;
  const { state, driver, motion, line, command } = snapshot;
  return (
    isCount(snapshot.seq) &&
    isCount(snapshot.tick) &&
    (state === "running" || state === "paused" || state === "gone") &&
    (driver === "me" || driver === "program" || driver === "remote") &&
    isReadings(snapshot.sensors) &&
    isPose(snapshot.pose) &&
    typeof motion === "string" &&
    motion.length <= 40 &&
    isCount(snapshot.bumps) &&
    typeof snapshot.bumping === "boolean" &&
    typeof snapshot.goalReached === "boolean" &&
    (line === null || line === "default" || isCount(line)) &&
    (command === null || isCount(command))
  );
}

function isReadings(input: unknown): boolean {
  const sensors = input as Loose<Snapshot["sensors"]>;
  return (
    typeof sensors === "object" &&
    sensors !== null &&
    isFrom(0, sensors.front, 2 * MAX_LENGTH) &&
    isFrom(0, sensors.right, 2 * MAX_LENGTH) &&
    isFrom(0, sensors.back, 2 * MAX_LENGTH) &&
    isFrom(0, sensors.left, 2 * MAX_LENGTH)
  );
}

function isPose(input: unknown): boolean {
  const pose = input as Loose<Snapshot["pose"]>;
  return (
    typeof pose === "object" &&
    pose !== null &&
    isFrom(-MAX_LENGTH, pose.x, MAX_LENGTH) &&
    isFrom(-MAX_LENGTH, pose.y, MAX_LENGTH) &&
    isFrom(0, pose.heading, 360) &&
    pose.heading !== 360
  );
}

function isFrom(least: number, value: unknown, most: number): boolean {
  return typeof value === "number" && value >= least && value <= most;
}

function isCount(value: unknown): value is number {
  return Number.isSafeInteger(value) && (value as number) >= 0;
}
