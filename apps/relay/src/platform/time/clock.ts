/** Time source of the relay. Tests replace it to simulate hours. */
export interface Clock {
  /** ms since 1970; never decreases while the relay runs */
  now(): number;
  /**
   * Calls `call` once after `ms` milliseconds; 0: after the messages that have arrived.
   * @returns a function that cancels the call
   */
  after(ms: number, call: () => void): () => void;
}

/** Wall-clock jumps above this mean that the clock was set or the machine slept. */
const JUMP_MS = 2_000;

export interface TimeSources {
  /** ms since 1970 by the machine's wall clock */
  wall(): number;
  /** ms of a monotonic clock */
  monotonic(): number;
}

const machine: TimeSources = { wall: () => Date.now(), monotonic: () => performance.now() };

/**
 * A monotonic clock that starts at the wall-clock time. If the wall clock jumps ahead (it was set,
 * or the machine slept), this clock follows, so that deadlines still hold. If the wall clock is set
 * back, this clock continues, so that no deadline is extended. Its timers do not keep the process
 * alive.
 * @param onJump receives each jump in ms; negative if the clock was set back
 */
export function steadyClock(onJump: (ms: number) => void, sources: TimeSources = machine): Clock {
  /** difference between the returned time and the monotonic clock */
  let ahead = sources.wall() - sources.monotonic();
  /** difference between the wall clock and the monotonic clock at the last reading */
  let lastOffset = ahead;
  return {
    now: () => {
      const passed = sources.monotonic();
      const offset = sources.wall() - passed;
      if (Math.abs(offset - lastOffset) > JUMP_MS) {
        onJump(Math.round(offset - lastOffset));
        lastOffset = offset;
        ahead = Math.max(ahead, offset);
      }
      return Math.round(passed + ahead);
    },
    after: (ms, call) => {
      // A timer waits for at least 1 ms.
      if (ms <= 0) {
        const immediate = setImmediate(call).unref();
        return () => clearImmediate(immediate);
      }
      const timer = setTimeout(call, ms).unref();
      return () => clearTimeout(timer);
    },
  };
}

/** The machine's clock, for callers that do not log jumps. */
export const systemClock: Clock = steadyClock(() => undefined);
