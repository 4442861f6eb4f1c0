/**
 * The tick from which the run of a link plays: `/?from=744#LINK`. A teacher who opens a failed run
 * sees its last seconds first.
 */

const PARAMETER = "from";

/** The address of a run that plays from a tick. @param link text of the link, after `#` */
export function replayAddress(link: string, tick: number): string {
  return `/?${PARAMETER}=${tick}#${link}`;
}

/** The tick in the search part of an address; null if it has none. */
export function replayStart(search: string): number | null {
  const text = new URLSearchParams(search).get(PARAMETER) ?? "";
  return /^\d{1,9}$/.test(text) ? Number(text) : null;
}

export function withoutReplayStart(search: string): string {
  const parameters = new URLSearchParams(search);
  parameters.delete(PARAMETER);
  return parameters.size === 0 ? "" : `?${parameters}`;
}
