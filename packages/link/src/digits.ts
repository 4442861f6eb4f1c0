/**
 * The 64 characters of a link, none of which needs percent-encoding in a URL fragment, and the
 * checksum over them.
 */

const ALPHABET = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/** Length of the checksum in characters. */
export const CHECK_LENGTH = 4;
/**
 * Generator of CRC-24 (RFC 9580). It detects every change within 24 consecutive bits, or 4
 * characters.
 */
const CRC_GENERATOR = 0x1864cfb;
const CRC_START = 0xb704ce;
const CRC_TOP = 0x1000000;

/** Converts digits to text. @param digits numbers from 0 to 63 */
export function textOf(digits: readonly number[]): string {
  return digits.map((digit) => ALPHABET[digit]).join("");
}

/** Converts text to digits, with null for an invalid character. */
export function digitsOf(text: string): (number | null)[] {
  return Array.from(text, (character) => {
    const digit = ALPHABET.indexOf(character);
    return digit === -1 ? null : digit;
  });
}

/** Computes the checksum over a link's version and digits: `CHECK_LENGTH` digits. */
export function checkOf(version: number, digits: readonly number[]): number[] {
  let crc = CRC_START;
  for (const digit of [version, ...digits]) {
    crc ^= digit << 18;
    for (let bit = 0; bit < 6; bit += 1) {
      crc *= 2;
      if (crc >= CRC_TOP) crc ^= CRC_GENERATOR;
    }
  }
  return [crc >> 18, (crc >> 12) & 63, (crc >> 6) & 63, crc & 63];
}
