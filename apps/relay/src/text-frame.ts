/**
 * A text as a WebSocket server sends it (RFC 6455, 5.2): header and message in one piece, which the connection
 * writes at once. `ws` writes the two apart, and that costs nearly as much again.
 */

/** All of a text, in one frame, uncompressed. */
const WHOLE_TEXT = 0x81;
/** A longer message has its length in two more bytes, or in eight. */
const MOST_SHORT = 125;
const MOST_IN_TWO = 0xffff;
const IN_TWO = 126;
const IN_EIGHT = 127;

/** The message as a frame. */
export function textFrame(text: string): Buffer {
  const length = Buffer.byteLength(text);
  const frame = emptyFrame(length, { isKept: false });
  frame.write(text, frame.length - length);
  return frame;
}

/**
 * A frame with its header; so many bytes of a message are yet to be written at its end.
 * @param isKept it may be kept for hours: its memory is its own, not shared with others of the same moment
 */
export function emptyFrame(length: number, { isKept }: { isKept: boolean }): Buffer {
  const size = headerBytes(length) + length;
  const frame = isKept ? Buffer.allocUnsafeSlow(size) : Buffer.allocUnsafe(size);
  frame[0] = WHOLE_TEXT;
  if (length <= MOST_SHORT) {
    frame[1] = length;
  } else if (length <= MOST_IN_TWO) {
    frame[1] = IN_TWO;
    frame[2] = length >> 8;
    frame[3] = length;
  } else {
    frame[1] = IN_EIGHT;
    frame.writeBigUInt64BE(BigInt(length), 2);
  }
  return frame;
}

/** The bytes of the message in a frame. */
export function messageIn(frame: Buffer): Buffer {
  if (frame[1] === IN_EIGHT) return frame.subarray(10);
  return frame.subarray(frame[1] === IN_TWO ? 4 : 2);
}

function headerBytes(length: number): number {
  if (length <= MOST_SHORT) return 2;
  return length <= MOST_IN_TWO ? 4 : 10;
}
