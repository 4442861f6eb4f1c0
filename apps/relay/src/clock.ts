/** Time as the relay sees it, so that tests can pass hours in a moment. */
export interface Clock {
  /** wall clock, ms since 1970 */
  now(): number;
  /** Calls once after so many ms. @returns a function that calls it off */
  after(ms: number, call: () => void): () => void;
}

/** The machine's own clock. Its timers do not keep the process alive. */
export const systemClock: Clock = {
  now: () => Date.now(),
  after: (ms, call) => {
    const timer = setTimeout(call, ms).unref();
    return () => clearTimeout(timer);
  },
};
