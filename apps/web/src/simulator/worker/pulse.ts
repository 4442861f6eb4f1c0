/**
 * The regular turns of the worker: often while something moves, seldom while nothing does. 125 turns
 * per second cost an idle page 1 to 3 % of a core, and a tablet its battery.
 */

/** Half of a 60 Hz frame, so that no frame waits for a whole interval. */
export const FAST_MS = 8;
/** Short enough that nobody notices a change that waits for a turn. */
export const SLOW_MS = 50;

/**
 * @param turn returns whether something moves
 * @returns a function that takes a turn at once, after something may have begun to move
 */
export function startPulse(turn: () => boolean): () => void {
  let timer: ReturnType<typeof setInterval> | undefined;
  let intervalMs = 0;
  const beat = (): void => {
    const nextMs = turn() ? FAST_MS : SLOW_MS;
    if (nextMs === intervalMs) return;
    intervalMs = nextMs;
    clearInterval(timer);
    timer = setInterval(beat, nextMs);
  };
  beat();
  return beat;
}
