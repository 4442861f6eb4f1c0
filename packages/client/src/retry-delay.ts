/** When to send the same request again after a temporary failure. */
import type { HttpResponse } from "./platform.ts";

/** A longer `Retry-After` counts as this many seconds. */
const MAX_RETRY_AFTER = 60;

/**
 * The delay until the same request is sent again.
 * @param response null: there was none
 * @param delayMs the client's own delay, added to `Retry-After` so that clients spread their attempts
 * @returns ms
 */
export function retryDelay(response: HttpResponse | null, delayMs: number): number {
  const header = response?.retryAfter ?? "";
  const seconds = /^\d{1,9}$/.test(header) ? Number(header) : 0;
  return Math.min(seconds, MAX_RETRY_AFTER) * 1_000 + delayMs;
}
