/**
 * Seeded random numbers: sfc32 (Chris Doty-Humphrey, PractRand), whole numbers only.
 * The same seed gives the same numbers in every engine; nothing here reads a clock.
 */

/** A source of random numbers that moves on with every call. */
export interface Random {
  /** a whole number from 0 to `limit` - 1; `limit` is a whole number from 1 to 2^32 */
  below: (limit: number) => number;
}

/** Rounds that mix the seed into all four words before the first number is given out. */
const WARM_UP_ROUNDS = 12;
const WORD = 4_294_967_296;

/** @param seed any finite number; its whole part counts modulo 2^64 */
export function createRandom(seed: number): Random {
  const whole = Math.floor(seed);
  let a = 0;
  let b = whole | 0;
  let c = Math.floor(whole / WORD) | 0;
  let counter = 1;

  const next = (): number => {
    const sum = (((a + b) | 0) + counter) | 0;
    counter = (counter + 1) | 0;
    a = b ^ (b >>> 9);
    b = (c + (c << 3)) | 0;
    c = (((c << 21) | (c >>> 11)) + sum) | 0;
    return sum >>> 0;
  };
  for (let round = 0; round < WARM_UP_ROUNDS; round += 1) next();

  return {
    below: (limit) => {
      // Numbers from the incomplete last stretch would favour small results; draw again.
      const fair = WORD - (WORD % limit);
      let word = next();
      while (word >= fair) word = next();
      return word % limit;
    },
  };
}
