/** Time and timers, which sessions of other protocols receive from their transport. */
export interface Timers {
  /** ms of a clock that never decreases */
  now(): number;
  /**
   * Calls `call` once after `ms` milliseconds, never at once. @returns a function that cancels the call
   */
  after(ms: number, call: () => void): () => void;
}
