/**
 * Path2D objects with their SVG path data. A Path2D does not expose its data, but the SVG export
 * needs it.
 */

const texts = new WeakMap<Path2D, string>();

/** Creates a Path2D from SVG path data. */
export function svgPath(text: string): Path2D {
  const path = new Path2D(text);
  texts.set(path, text);
  return path;
}

/**
 * Returns the path data that was given to `svgPath`.
 * @throws Error for a path that was not created by `svgPath`
 */
export function svgPathData(path: Path2D): string {
  const text = texts.get(path);
  if (text === undefined) throw new Error("This path was not made by svgPath");
  return text;
}
