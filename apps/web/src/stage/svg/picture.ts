/** SVG pictures for files, their colours, and the conversion to PNG. */
import { readPalette, type Palette } from "../drawing/palette.ts";

/** PNG pixels for one pixel of the picture, and the longest side that every browser can draw. */
const PNG_SCALE = 2;
const MAX_PNG_SIDE = 4096;

export interface Picture {
  svg: string;
  width: number;
  height: number;
}

/**
 * Converts the picture to a PNG at twice its size, or less if a side would exceed `MAX_PNG_SIDE`.
 * @throws Error if the browser cannot draw it
 */
export async function pngOf({ svg, width, height }: Picture): Promise<Blob> {
  const scale = Math.min(PNG_SCALE, MAX_PNG_SIDE / Math.max(width, height));
  const url = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = new Image(Math.round(width * scale), Math.round(height * scale));
    image.src = url;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = image.width;
    canvas.height = image.height;
    canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
    const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/png"));
    if (blob === null) throw new Error("the canvas gave no picture");
    return blob;
  } finally {
    URL.revokeObjectURL(url);
  }
}

/** The colours of the light theme, whatever the theme of the page: pictures are for paper. */
export function lightPalette(): Palette {
  const probe = document.createElement("div");
  probe.dataset["theme"] = "light";
  probe.hidden = true;
  document.body.append(probe);
  const style = getComputedStyle(probe);
  const palette = readPalette((property) => style.getPropertyValue(property));
  probe.remove();
  return palette;
}
