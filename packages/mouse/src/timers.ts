/** What a session needs besides the robot. */
export interface Timers {
  /** ms of a clock that never decreases */
  now(): number;
  /** Calls `call` once after `ms` milliseconds. @returns a function that cancels the call */
  after(ms: number, call: () => void): () => void;
}
