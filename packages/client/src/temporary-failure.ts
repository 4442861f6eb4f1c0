/** Which responses are temporary failures, and when to send the same request again. */
import type { HttpResponse } from "./platform.ts";

/** Request timeout, too early, too many requests. All statuses from 500 are temporary too. */
const statuses: ReadonlySet<number> = new Set([408, 425, 429]);
/** A longer `Retry-After` counts as this many seconds. */
const MAX_RETRY_AFTER = 60;

/** Whether the same request may succeed later. */
export function isTemporary({ status }: { status: number }): boolean {
  return status >= 500 || statuses.has(status);
}

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
