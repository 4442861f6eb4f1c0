/**
 * One clock for all processes of this machine, so that the times of sending and of starting a
 * command can be compared.
 */

/** ms of a monotonic clock that all processes share */
export function machineNow(): number {
  return Number(process.hrtime.bigint()) / 1e6;
}

/** Converts a time of `machineNow` to the clock of `Date.now`. */
export function wallClock(at: number): number {
  return at + Date.now() - machineNow();
}

export function sleep(ms: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, Math.max(0, ms)));
}

/** Calls a function `perSecond` times a second for `ms`. Calls that are late are not dropped. */
export async function callRepeatedly(
  perSecond: number,
  ms: number,
  call: (n: number) => void,
): Promise<void> {
  const start = machineNow();
  const count = Math.round((ms / 1000) * perSecond);
  for (let n = 0; n < count; n++) {
    const wait = start + (n * 1000) / perSecond - machineNow();
    if (wait > 0) await sleep(wait);
    call(n);
  }
}

/**
 * Waits until a condition is true.
 * @returns the ms waited, or Infinity when the condition was not true in time
 */
export async function waitUntil(isTrue: () => boolean, withinMs: number): Promise<number> {
  const start = machineNow();
  while (!isTrue()) {
    if (machineNow() - start > withinMs) return Infinity;
    await sleep(5);
  }
  return machineNow() - start;
}
