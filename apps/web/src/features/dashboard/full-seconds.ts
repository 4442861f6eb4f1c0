/** The full seconds of the device's clock. What waits for the same one runs in one task. */

const SECOND_MS = 1_000;
/** What waits, by the time at which it is due. */
const waiting = new Map<number, Set<() => void>>();

/** The first full second at or after a time, in ms since 1970. */
export function fullSecond(at: number): number {
  return Math.ceil(at / SECOND_MS) * SECOND_MS;
}

/**
 * Calls back at the first full second at or after a time.
 * @returns a function that cancels
 */
export function atFullSecond(at: number, call: () => void): () => void {
  const dueAt = fullSecond(at);
  const calls = waiting.get(dueAt) ?? wait(dueAt);
  calls.add(call);
  return () => calls.delete(call);
}

function wait(dueAt: number): Set<() => void> {
  const calls = new Set<() => void>();
  waiting.set(dueAt, calls);
  setTimeout(() => {
    waiting.delete(dueAt);
    for (const call of calls) call();
  }, dueAt - Date.now());
  return calls;
}
