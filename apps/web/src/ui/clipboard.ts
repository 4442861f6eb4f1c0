/**
 * Copies text. Browsers refuse on insecure pages (HTTP on a school's own server), or by user
 * choice.
 */

/** The part of the browser's Clipboard that the page uses. */
export interface TextClipboard {
  writeText: (text: string) => Promise<void>;
}

/** @returns false if the browser refused; the page must then offer the text for copying by hand */
export async function copyText(
  text: string,
  clipboard: TextClipboard | undefined,
): Promise<boolean> {
  if (clipboard === undefined) return false;
  try {
    await clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

/** The page's clipboard; undefined if the browser has none on insecure pages. */
export function pageClipboard(): TextClipboard | undefined {
  return "clipboard" in navigator ? navigator.clipboard : undefined;
}
