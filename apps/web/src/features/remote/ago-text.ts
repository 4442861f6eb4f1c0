/** "5 minutes ago", in the language of the page. */
const MINUTE_MS = 60_000;
const HOUR_MS = 60 * MINUTE_MS;

export function agoText(milliseconds: number, language: string): string {
  const format = new Intl.RelativeTimeFormat(`${language}-u-nu-latn`, { numeric: "auto" });
  // Days are not needed: a robot exists for one day.
  return milliseconds < HOUR_MS
    ? format.format(-Math.floor(milliseconds / MINUTE_MS), "minute")
    : format.format(-Math.floor(milliseconds / HOUR_MS), "hour");
}
