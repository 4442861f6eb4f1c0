/** Time as the relay sees it, so that tests can pass hours in a moment. */
export interface Clock {
  /** ms since 1970; never goes back while the relay runs */
  now(): number;
  /** Calls once after so many ms. @returns a function that calls it off */
  after(ms: number, call: () => void): () => void;
}

/** A wall clock that is so far off was set, or the machine slept. */
const JUMP_MS = 2_000;

export interface TimeSources {
  /** ms since 1970, as the machine believes at the moment */
  wall(): number;
  /** ms that pass evenly */
  monotonic(): number;
}

const machine: TimeSources = { wall: () => Date.now(), monotonic: () => performance.now() };

/**
 * The wall clock of the start, carried on evenly. Where the machine's wall clock jumps ahead (it was
 * set, or the machine slept) this one follows, so that what was to happen by a deadline does not happen
 * after it; where it is set back, this one goes on, so that nothing gets more time. Its timers do not
 * keep the process alive.
 * @param jumped is told of each jump, in ms; negative: back
 */
export function steadyClock(jumped: (ms: number) => void, sources: TimeSources = machine): Clock {
  /** between what passes evenly and the time that is told */
  let ahead = sources.wall() - sources.monotonic();
  /** between what passes evenly and the wall clock, when it was last looked at */
  let seen = ahead;
  return {
    now: () => {
      const passed = sources.monotonic();
      const offset = sources.wall() - passed;
      if (Math.abs(offset - seen) > JUMP_MS) {
        jumped(Math.round(offset - seen));
        seen = offset;
        ahead = Math.max(ahead, offset);
      }
      return Math.round(passed + ahead);
    },
    after: (ms, call) => {
      const timer = setTimeout(call, ms).unref();
      return () => clearTimeout(timer);
    },
  };
}

/** The machine's own clock, for whoever has no log to tell of jumps. */
export const systemClock: Clock = steadyClock(() => undefined);
