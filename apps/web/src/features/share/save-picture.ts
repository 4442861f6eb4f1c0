/** Gives the reader a drawing as an SVG file. */

/** @param name what the file is called, without ending; any text */
export function savePicture(picture: SVGSVGElement, name: string): void {
  const text = new XMLSerializer().serializeToString(picture);
  const url = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  const link = document.createElement("a");
  link.href = url;
  link.download = `${fileName(name)}.svg`;
  link.click();
  // The download has the data by the time the next task runs.
  setTimeout(() => URL.revokeObjectURL(url), 0);
}

/** Letters and digits of any script; everything else would trouble one file system or another. */
export function fileName(name: string): string {
  const clean = name
    .toLowerCase()
    .replaceAll(/[^\p{Letter}\p{Mark}\p{Number}]+/gu, "-")
    .replaceAll(/^-|-$/g, "");
  return clean === "" ? "maze" : clean;
}
