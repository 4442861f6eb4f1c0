/** Deletes what has expired in several steps, because each step blocks Redis. */
import { z } from "zod";

/** Robots or classes to delete per step. */
const MOST_AT_ONCE = 100;

/**
 * @param before last used or created before these times
 * @param step a step of a script that follows expiry.lua
 * @returns the deleted ids
 */
export async function removeExpired(
  before: { lastUsedAt: number; createdAt: number },
  step: (values: object) => Promise<unknown>,
): Promise<string[]> {
  const all: string[] = [];
  for (;;) {
    const values = { ...before, most: MOST_AT_ONCE };
    const ids = z.array(z.string()).parse(await step(values));
    all.push(...ids);
    if (ids.length < MOST_AT_ONCE) return all;
  }
}
