/** Time and timers for the protocols of bridges. */
export const clock = {
  /** ms of a clock that never decreases */
  now: (): number => performance.now(),
  /** Calls `call` once after `ms` milliseconds. @returns a function that cancels the call */
  after(ms: number, call: () => void): () => void {
    // A timer waits for at least 1 ms.
    if (ms <= 0) {
      const immediate = setImmediate(call);
      return () => clearImmediate(immediate);
    }
    const timer = setTimeout(call, ms);
    return () => clearTimeout(timer);
  },
};
