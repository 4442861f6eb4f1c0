/** How long a request waits, and what ends the wait early. */
export interface WaitLimit {
  milliseconds: number;
  signal: AbortSignal;
}
