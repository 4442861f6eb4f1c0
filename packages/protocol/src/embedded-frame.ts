/** The HTML that shows Corridor in a frame of another site. */

/** Sizes of the frame that the page and oEmbed offer, in CSS pixels. */
export const frameSizes = {
  small: { width: 360, height: 560 },
  medium: { width: 720, height: 600 },
  large: { width: 1080, height: 680 },
} as const;

export type FrameSize = keyof typeof frameSizes;

export interface EmbeddedFrame {
  /** of `/embed` */
  address: string;
  /** name of the frame for screen readers */
  title: string;
  width: number;
  height: number;
}

const entities: ReadonlyMap<string, string> = new Map([
  ["&", "&amp;"],
  ["<", "&lt;"],
  [">", "&gt;"],
  ['"', "&quot;"],
]);

/** An `iframe` element as HTML text. */
export function frameMarkup({ address, title, width, height }: EmbeddedFrame): string {
  return (
    `<iframe src="${escaped(address)}" title="${escaped(title)}" width="${width}" height="${height}" ` +
    `style="border:0;max-width:100%" loading="lazy" allow="clipboard-write; fullscreen"></iframe>`
  );
}

function escaped(text: string): string {
  return text.replaceAll(/[&<>"]/g, (character) => entities.get(character) ?? "");
}
