/**
 * Seeded random integers by sfc32 (Chris Doty-Humphrey, PractRand). A seed produces the same
 * numbers in every JavaScript engine.
 */

/** A stateful source of random numbers. */
export interface Random {
  /** Returns a whole number from 0 to `limit` - 1. `limit` is a whole number from 1 to 2^32. */
  below: (limit: number) => number;
}

/** Rounds that mix the seed into all four words before the first number is returned. */
const WARM_UP_ROUNDS = 12;
const WORD = 4_294_967_296;

/** @param seed any finite number, rounded down and reduced modulo 2^64 */
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
      // Rejection sampling: words from the incomplete last interval would favour small results.
      const fair = WORD - (WORD % limit);
      let word = next();
      while (word >= fair) word = next();
      return word % limit;
    },
  };
}
