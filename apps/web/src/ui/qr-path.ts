/** A QR code as one SVG path. The package uqr computes the modules. */
import { encode } from "uqr";

export interface QrPath {
  /** modules per side, including the quiet zone */
  size: number;
  path: string;
}

/** The quiet zone that scanners need around the code, in modules. */
const QUIET_ZONE = 4;
/** Capacity of the largest code (version 40, lowest error correction), in bytes. */
const MAX_BYTES = 2_953;

/** @returns null if the text is too long for a QR code */
export function qrPath(text: string): QrPath | null {
  if (new TextEncoder().encode(text).length > MAX_BYTES) return null;
  const { data, size } = encode(text, { ecc: "L", border: QUIET_ZONE });
  let path = "";
  for (const [y, row] of data.entries()) {
    let start = 0;
    for (let x = 0; x <= row.length; x++) {
      if (row[x] === true) continue;
      if (x > start) path += `M${start} ${y}h${x - start}v1h${start - x}z`;
      start = x + 1;
    }
  }
  return { size, path };
}
