/**
 * One clock for all processes of this machine: when a command was sent here and begun there can be
 * compared.
 */

/** ms by a clock that is never set back, the same in every process */
export function machineNow(): number {
  return Number(process.hrtime.bigint()) / 1e6;
}

/** The same moment as `Date.now` has it, in this process and in others. */
export function wallClock(at: number): number {
  return at + Date.now() - machineNow();
}

export function sleep(ms: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, Math.max(0, ms)));
}

/** Calls once now and then so often a second, for so long; a call that is late is made up for. */
export async function everyFor(
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
 * Waits until something is true.
 * @returns ms that it took; Infinity when it did not come in time
 */
export async function until(isTrue: () => boolean, withinMs: number): Promise<number> {
  const start = machineNow();
  while (!isTrue()) {
    if (machineNow() - start > withinMs) return Infinity;
    await sleep(5);
  }
  return machineNow() - start;
}
