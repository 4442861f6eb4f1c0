/**
 * Shapes that are written down as SVG path data. A Path2D does not tell what it was made of, but who
 * draws into an SVG file has to know.
 */

const texts = new WeakMap<Path2D, string>();

/** A path made of SVG path data. */
export function pathOf(text: string): Path2D {
  const path = new Path2D(text);
  texts.set(path, text);
  return path;
}

/** The path data that `pathOf` was given. @throws Error for a path that was made elsewhere */
export function textOf(path: Path2D): string {
  const text = texts.get(path);
  if (text === undefined) throw new Error("This path was not made by pathOf");
  return text;
}
