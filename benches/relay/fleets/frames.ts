/**
 * WebSocket frames as a client needs them, and nothing more: text of up to 64 KiB in one piece, pings and
 * goodbyes. A load that costs little leaves the machine to what is measured, and meets all alike.
 */
export const TEXT = 1;
export const CLOSE = 8;
export const PING = 9;
export const PONG = 10;

export interface Frame {
  opcode: number;
  payload: Buffer;
}

/** Any mask will do: it hides nothing, it only keeps old proxies from misreading. */
const MASK = [0x37, 0xfa, 0x21, 0x3d] as const;

/** A masked frame. @param payload at most 65,535 bytes */
export function frameOf(opcode: number, payload: Buffer): Buffer {
  const { length } = payload;
  const head = length < 126 ? 2 : 4;
  const frame = Buffer.allocUnsafe(head + 4 + length);
  frame[0] = 0x80 | opcode;
  if (length < 126) frame[1] = 0x80 | length;
  else {
    frame[1] = 0x80 | 126;
    frame.writeUInt16BE(length, 2);
  }
  for (let i = 0; i < 4; i++) frame[head + i] = MASK[i] ?? 0;
  for (let i = 0; i < length; i++) {
    frame[head + 4 + i] = (payload[i] ?? 0) ^ (MASK[i & 3] ?? 0);
  }
  return frame;
}

/** Takes whole frames off the beginning of what came. @returns the rest, which is not whole yet */
export function takeFrames(bytes: Buffer, take: (frame: Frame) => void): Buffer {
  let at = 0;
  while (bytes.length - at >= 2) {
    const short = (bytes[at + 1] ?? 0) & 0x7f;
    if (short === 127) throw new Error("a frame of more than 64 KiB");
    const head = short === 126 ? 4 : 2;
    if (bytes.length - at < head) break;
    const length = short === 126 ? bytes.readUInt16BE(at + 2) : short;
    const end = at + head + length;
    if (bytes.length < end) break;
    take({ opcode: (bytes[at] ?? 0) & 0x0f, payload: bytes.subarray(at + head, end) });
    at = end;
  }
  return bytes.subarray(at);
}
