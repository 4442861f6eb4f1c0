/**
 * Encodes messages as text and decodes them. Decoding never throws: it returns the message or a
 * list of problems. All messages are parsed here.
 */
import type { z } from "zod";
import { readJson, type ReadResult } from "./document-reader.ts";
import type {
  ClassHello,
  RelayToScreen,
  RelayToStudent,
  RelayToTeacher,
  ScreenToRelay,
  StudentToRelay,
  TeacherToRelay,
} from "./class-messages.ts";
import type {
  DriverToRelay,
  Hello,
  PageToRelay,
  RelayToDriver,
  RelayToPage,
  Resume,
} from "./messages.ts";

/** Largest message and largest request body, in bytes. */
export const MAX_FRAME_BYTES = 16 * 1024;
/** Largest `hello`, in bytes: the sender is not authenticated yet. */
export const MAX_HELLO_BYTES = 1024;

type RobotFrame = Hello | Resume | PageToRelay | RelayToPage | DriverToRelay | RelayToDriver;
type ClassFrame =
  | ClassHello
  | StudentToRelay
  | RelayToStudent
  | TeacherToRelay
  | RelayToTeacher
  | ScreenToRelay
  | RelayToScreen;

/** The message as one JSON text. */
export function encodeFrame(frame: RobotFrame | ClassFrame): string {
  return JSON.stringify(frame);
}

/**
 * Decodes one message.
 * @param schema the messages of that direction, such as `pageToRelaySchema`
 * @param maxLength in UTF-16 code units
 */
export function decodeFrame<T>(
  schema: z.ZodType<T>,
  text: string,
  maxLength: number = MAX_FRAME_BYTES,
): ReadResult<T> {
  return readJson(schema, text, maxLength);
}
