/**
 * A text as a WebSocket frame of a server (RFC 6455, 5.2): header and payload in one buffer, for a
 * single write. `ws` writes them separately, at nearly twice the cost.
 */

/** First byte of an unfragmented, uncompressed text frame. */
const FINAL_TEXT = 0x81;
/** Payloads above these lengths store their length in two or eight extra bytes. */
const MAX_SHORT = 125;
const MAX_TWO_BYTES = 0xffff;
const TWO_BYTE_LENGTH = 126;
const EIGHT_BYTE_LENGTH = 127;

/** Encodes a text as a frame. */
export function textFrame(text: string): Buffer {
  const length = Buffer.byteLength(text);
  const frame = emptyFrame(length, { isRetained: false });
  frame.write(text, frame.length - length);
  return frame;
}

/**
 * Allocates a frame and writes its header. The caller writes the payload of `length` bytes at its
 * end.
 * @param isRetained the frame may be stored for hours, so it must not share a pooled buffer
 */
export function emptyFrame(length: number, { isRetained }: { isRetained: boolean }): Buffer {
  const size = headerSize(length) + length;
  const frame = isRetained ? Buffer.allocUnsafeSlow(size) : Buffer.allocUnsafe(size);
  frame[0] = FINAL_TEXT;
  if (length <= MAX_SHORT) {
    frame[1] = length;
  } else if (length <= MAX_TWO_BYTES) {
    frame[1] = TWO_BYTE_LENGTH;
    frame[2] = length >> 8;
    frame[3] = length;
  } else {
    frame[1] = EIGHT_BYTE_LENGTH;
    frame.writeBigUInt64BE(BigInt(length), 2);
  }
  return frame;
}

/** Returns the payload of a frame. */
export function messageIn(frame: Buffer): Buffer {
  if (frame[1] === EIGHT_BYTE_LENGTH) return frame.subarray(10);
  return frame.subarray(frame[1] === TWO_BYTE_LENGTH ? 4 : 2);
}

function headerSize(length: number): number {
  if (length <= MAX_SHORT) return 2;
  return length <= MAX_TWO_BYTES ? 4 : 10;
}
