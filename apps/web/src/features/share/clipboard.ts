/** Copying text. Browsers refuse where the page is not secure (http on a school's own server) or asked not to. */

/** As much of the browser's Clipboard as is needed. */
export interface TextClipboard {
  writeText: (text: string) => Promise<void>;
}

/** @returns false when the browser refused; then the text must be offered for copying by hand */
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

/** The page's clipboard; undefined where the browser has none for pages that are not secure. */
export function pageClipboard(): TextClipboard | undefined {
  return "clipboard" in navigator ? navigator.clipboard : undefined;
}
