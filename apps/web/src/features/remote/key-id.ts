/**
 * The id by which the service lists a key: the first characters of its SHA-256 in base64url.
 * Computed here because `crypto.subtle` needs HTTPS, and classrooms often reach the service by
 * plain HTTP.
 */

// prettier-ignore
const ROUNDS = [
  0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
  0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
  0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
  0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
  0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
  0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
  0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
  0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2,
];
const BEGIN = [
  0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19,
];
const BLOCK = 64;
const ID_LETTERS = 6;

export function keyIdOf(key: string): string {
  let state = BEGIN;
  const bytes = padded(new TextEncoder().encode(key));
  for (let at = 0; at < bytes.byteLength; at += BLOCK) {
    state = mixed(state, new DataView(bytes.buffer, at, BLOCK));
  }
  // Six characters of base64 are 36 bits, which the first two words contain.
  const first = state
    .slice(0, 2)
    .flatMap((word) => [24, 16, 8, 0].map((by) => (word >>> by) & 255));
  const base64 = btoa(String.fromCharCode(...first));
  return base64.replaceAll("+", "-").replaceAll("/", "_").slice(0, ID_LETTERS);
}

/** The padded message: a 1 bit after the text, whole blocks, and the length in bits at the end. */
function padded(text: Uint8Array): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(Math.ceil((text.length + 9) / BLOCK) * BLOCK);
  bytes.set(text);
  bytes[text.length] = 0x80;
  new DataView(bytes.buffer).setUint32(bytes.length - 4, text.length * 8);
  return bytes;
}

/** FIPS 180-4, section 6.2.2. */
function mixed(state: readonly number[], block: DataView): number[] {
  const words = ROUNDS.map((_, at) => (at < 16 ? block.getUint32(at * 4) : 0));
  const word = (at: number): number => words[at] ?? 0;
  for (let at = 16; at < ROUNDS.length; at++) {
    const early = turned(word(at - 15), 7, 18) ^ (word(at - 15) >>> 3);
    const late = turned(word(at - 2), 17, 19) ^ (word(at - 2) >>> 10);
    words[at] = (word(at - 16) + early + word(at - 7) + late) | 0;
  }
  let [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0] = state;
  for (const [at, round] of ROUNDS.entries()) {
    const choice = (e & f) ^ (~e & g);
    const one = (h + (turned(e, 6, 11) ^ turned(e, 25)) + choice + round + word(at)) | 0;
    const majority = (a & b) ^ (a & c) ^ (b & c);
    const two = ((turned(a, 2, 13) ^ turned(a, 22)) + majority) | 0;
    [h, g, f, e, d, c, b, a] = [g, f, e, (d + one) | 0, c, b, a, (one + two) | 0];
  }
  return [a, b, c, d, e, f, g, h].map((value, at) => (value + (state[at] ?? 0)) | 0);
}

/** The XOR of a word's right rotations by each of these numbers of bits. */
function turned(value: number, ...bits: number[]): number {
  return bits.reduce((all, by) => all ^ ((value >>> by) | (value << (32 - by))), 0);
}
