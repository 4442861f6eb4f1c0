/** Gives the reader a drawing as an SVG file. */
import { fileName } from "../files/file-name.ts";
import { saveFile } from "../files/save-file.ts";

/** @param name what the file is called, without ending; any text */
export function savePicture(picture: SVGSVGElement, name: string): void {
  const text = new XMLSerializer().serializeToString(picture);
  saveFile(new Blob([text], { type: "image/svg+xml" }), `${fileName(name, "maze")}.svg`);
}
