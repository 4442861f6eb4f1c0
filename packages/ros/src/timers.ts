/** What a session needs of its transport: time, timers, and a connection. */
export interface Timers {
  /** ms of a clock that never decreases */
  now(): number;
  /**
   * Calls `call` once after `ms` milliseconds, never at once. @returns a function that cancels the call
   */
  after(ms: number, call: () => void): () => void;
}
