import { fileName } from "../../ui/file-name.ts";
import { saveFile } from "../../ui/save-file.ts";

/**
 * Saves a drawing as an SVG file.
 * @param name file name without its extension; any text
 */
export function savePicture(picture: SVGSVGElement, name: string): void {
  const text = new XMLSerializer().serializeToString(picture);
  saveFile(new Blob([text], { type: "image/svg+xml" }), `${fileName(name, "maze")}.svg`);
}
