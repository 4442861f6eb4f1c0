/**
 * A minimal WebSocket frame codec for clients: unfragmented text of up to 64 KiB, ping, pong and
 * close frames. It needs little processor time, which leaves the machine to the measured peer.
 */
export const TEXT = 1;
export const CLOSE = 8;
export const PING = 9;
export const PONG = 10;

export interface Frame {
  opcode: number;
  payload: Buffer;
}

/** A fixed mask. Masks only protect proxies (RFC 6455, 10.3), which the benchmark does not use. */
const MASK = [0x37, 0xfa, 0x21, 0x3d] as const;

/** Encodes a masked frame. @param payload at most 65,535 bytes */
export function encodeFrame(opcode: number, payload: Buffer): Buffer {
  const { length } = payload;
  const headerLength = length < 126 ? 2 : 4;
  const frame = Buffer.allocUnsafe(headerLength + 4 + length);
  frame[0] = 0x80 | opcode;
  if (length < 126) frame[1] = 0x80 | length;
  else {
    frame[1] = 0x80 | 126;
    frame.writeUInt16BE(length, 2);
  }
  for (let i = 0; i < 4; i++) frame[headerLength + i] = MASK[i] ?? 0;
  for (let i = 0; i < length; i++) {
    frame[headerLength + 4 + i] = (payload[i] ?? 0) ^ (MASK[i & 3] ?? 0);
  }
  return frame;
}

/**
 * Decodes all complete frames.
 * @param bytes unprocessed bytes of the stream
 * @param onFrame is called with each complete frame
 * @returns the remaining bytes, which are an incomplete frame
 * @throws Error if a frame is longer than 64 KiB
 */
export function decodeFrames(bytes: Buffer, onFrame: (frame: Frame) => void): Buffer {
  let at = 0;
  while (bytes.length - at >= 2) {
    const shortLength = (bytes[at + 1] ?? 0) & 0x7f;
    if (shortLength === 127) throw new Error("a frame is longer than 64 KiB");
    const headerLength = shortLength === 126 ? 4 : 2;
    if (bytes.length - at < headerLength) break;
    const length = shortLength === 126 ? bytes.readUInt16BE(at + 2) : shortLength;
    const end = at + headerLength + length;
    if (bytes.length < end) break;
    onFrame({ opcode: (bytes[at] ?? 0) & 0x0f, payload: bytes.subarray(at + headerLength, end) });
    at = end;
  }
  return bytes.subarray(at);
}
