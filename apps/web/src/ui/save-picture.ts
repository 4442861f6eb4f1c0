import { fileName } from "./file-name.ts";
import { saveFile } from "./save-file.ts";

/**
 * Saves a QR code as an SVG file.
 * @param name file name without its extension; any text
 */
export function savePicture(picture: SVGSVGElement, name: string): void {
  const text = new XMLSerializer().serializeToString(picture);
  saveFile(new Blob([text], { type: "image/svg+xml" }), `${fileName(name, "qr-code")}.svg`);
}
