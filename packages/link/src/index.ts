export type { CompletionCode } from "./completion-code.ts";
export type { LessonPart } from "./lesson-coder.ts";
export type { LinkContent } from "./link-body.ts";
export {
  attemptOf,
  handInsOf,
  readHandInFile,
  type HandIn,
  type HandInLine,
  type HandInRefusal,
  type HandInResult,
} from "./hand-in.ts";
export { readLessonLink, readLink, type AddressRefusal } from "./link-address.ts";
export { MAX_LINK_LENGTH } from "@corridor/protocol";
export {
  decodeLink,
  encodeLink,
  type DecodeResult,
  type EncodeRefusal,
  type EncodeResult,
  type LinkRefusal,
} from "./link.ts";
