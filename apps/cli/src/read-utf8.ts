/** Reads UTF-8 text. */
import { problem, type ReadResult } from "@corridor/protocol";

/** @param read reads the document from the text */
export function readUtf8<T>(
  bytes: Uint8Array,
  read: (text: string) => ReadResult<T>,
): ReadResult<T> {
  let text: string;
  try {
    text = new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return problem("", "bytes that are not UTF-8", "UTF-8 text");
  }
  return read(text);
}
