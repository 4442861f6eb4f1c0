/** Which responses are temporary failures. */

/** Request timeout, too early, too many requests. All statuses from 500 are temporary too. */
const statuses: ReadonlySet<number> = new Set([408, 425, 429]);

/** Whether the same request may succeed later. */
export function isTemporary({ status }: { status: number }): boolean {
  return status >= 500 || statuses.has(status);
}
