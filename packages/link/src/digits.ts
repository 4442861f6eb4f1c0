/**
 * The 64 characters of a link, all of which pass through a URL's fragment as they are, and the check
 * over them.
 */

const ALPHABET = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/** Characters that `checkOf` gives. */
export const CHECK_LENGTH = 4;
/** Generator of CRC-24 (RFC 9580): no change within 24 bits in a row, four characters, gets past it. */
const CRC_GENERATOR = 0x1864cfb;
const CRC_START = 0xb704ce;
const CRC_TOP = 0x1000000;

/** @param digits numbers from 0 to 63 */
export function textOf(digits: readonly number[]): string {
  return digits.map((digit) => ALPHABET[digit]).join("");
}

/** The digits of a text; null in the place of a character that no link has. */
export function digitsOf(text: string): (number | null)[] {
  return Array.from(text, (character) => {
    const digit = ALPHABET.indexOf(character);
    return digit === -1 ? null : digit;
  });
}

/** The check over a link's version and digits: four digits. */
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
