/** Reads messages of a dashboard, which may be larger than those of all other clients. */
import { teacherToRelaySchema, type TeacherToRelay } from "./class-messages.ts";
import { decodeFrame, MAX_FRAME_BYTES } from "./codec.ts";
import type { ReadResult } from "./document-reader.ts";

/** Largest message of a dashboard, in UTF-16 code units. */
export const MAX_DISPLAY_LENGTH = 64 * 1024;

/** Reads a message of a dashboard. Only `display` may have more than 16 KiB. */
export function decodeTeacherFrame(text: string): ReadResult<TeacherToRelay> {
  const read = decodeFrame(teacherToRelaySchema, text, MAX_DISPLAY_LENGTH);
  const isTooLong = read.ok && read.value.type !== "display" && text.length > MAX_FRAME_BYTES;
  return isTooLong ? decodeFrame(teacherToRelaySchema, text) : read;
}
