/**
 * A drawing context that writes SVG, so that the code that draws the stage can draw into a file.
 * Numbers are rounded to a hundredth of a pixel.
 */
import type { VectorContext } from "../drawing/drawing-context.ts";
import { svgPathData } from "../drawing/svg-path.ts";

type Style = string | CanvasGradient | CanvasPattern;

/** The state that `save` stores. */
interface Ink {
  fillStyle: Style;
  strokeStyle: Style;
  lineWidth: number;
  lineCap: CanvasLineCap;
  lineJoin: CanvasLineJoin;
  font: string;
  textAlign: CanvasTextAlign;
  textBaseline: CanvasTextBaseline;
  dash: readonly number[];
  transform: readonly string[];
}

const anchors: Record<CanvasTextAlign, string> = {
  left: "start",
  start: "start",
  center: "middle",
  right: "end",
  end: "end",
};

export class SvgPen implements VectorContext {
  fillStyle: Style = "#000";
  strokeStyle: Style = "#000";
  lineWidth = 1;
  lineCap: CanvasLineCap = "butt";
  lineJoin: CanvasLineJoin = "miter";
  font = "10px sans-serif";
  textAlign: CanvasTextAlign = "start";
  textBaseline: CanvasTextBaseline = "alphabetic";
  #dash: readonly number[] = [];
  #transform: readonly string[] = [];
  #path = "";
  readonly #saved: Ink[] = [];
  readonly #elements: string[] = [];

  /** All drawn SVG elements. */
  elements(): string {
    return this.#elements.join("\n");
  }

  save(): void {
    const { fillStyle, strokeStyle, lineWidth, lineCap, lineJoin } = this;
    const { font, textAlign, textBaseline } = this;
    this.#saved.push({
      fillStyle,
      strokeStyle,
      lineWidth,
      lineCap,
      lineJoin,
      font,
      textAlign,
      textBaseline,
      dash: this.#dash,
      transform: this.#transform,
    });
  }

  restore(): void {
    const ink = this.#saved.pop();
    if (ink === undefined) return;
    const { dash, transform, ...styles } = ink;
    Object.assign(this, styles);
    this.#dash = dash;
    this.#transform = transform;
  }

  translate(x: number, y: number): void {
    this.#transform = [...this.#transform, `translate(${short(x)} ${short(y)})`];
  }

  rotate(radians: number): void {
    this.#transform = [...this.#transform, `rotate(${short((radians * 180) / Math.PI)})`];
  }

  scale(x: number, y: number): void {
    // Factors are small: an error of a hundredth would be visible.
    this.#transform = [...this.#transform, `scale(${x.toPrecision(6)} ${y.toPrecision(6)})`];
  }

  setLineDash(dash: readonly number[]): void {
    this.#dash = dash;
  }

  beginPath(): void {
    this.#path = "";
  }

  moveTo(x: number, y: number): void {
    this.#path += `M${short(x)} ${short(y)}`;
  }

  lineTo(x: number, y: number): void {
    this.#path += `L${short(x)} ${short(y)}`;
  }

  closePath(): void {
    this.#path += "z";
  }

  /** Supports one radius for all corners, as all layers use it. */
  roundRect(x: number, y: number, width: number, height: number, radius: unknown = 0): void {
    const r = Math.min(typeof radius === "number" ? radius : 0, width / 2, height / 2);
    const corner = (dx: number, dy: number): string =>
      `a${short(r)} ${short(r)} 0 0 1 ${short(dx)} ${short(dy)}`;
    this.#path +=
      `M${short(x + r)} ${short(y)}h${short(width - 2 * r)}${corner(r, r)}` +
      `v${short(height - 2 * r)}${corner(-r, r)}h${short(2 * r - width)}${corner(-r, -r)}` +
      `v${short(2 * r - height)}${corner(r, -r)}z`;
  }

  fill(path?: Path2D | CanvasFillRule): void {
    this.#draw(`<path d="${this.#dataOf(path)}"${this.#fillWith()}`);
  }

  stroke(path?: Path2D): void {
    const dash =
      this.#dash.length === 0 ? "" : ` stroke-dasharray="${this.#dash.map(short).join(" ")}"`;
    this.#draw(
      `<path d="${this.#dataOf(path)}" fill="none"${attribute("stroke", this.strokeStyle)}` +
        ` stroke-width="${short(this.lineWidth)}" stroke-linecap="${this.lineCap}"` +
        ` stroke-linejoin="${this.lineJoin}"${dash}`,
    );
  }

  fillRect(x: number, y: number, width: number, height: number): void {
    const box = `x="${short(x)}" y="${short(y)}" width="${short(width)}" height="${short(height)}"`;
    this.#draw(`<rect ${box}${this.#fillWith()}`);
  }

  /** Squeezes a text that may be too wide, as the canvas does. */
  fillText(text: string, x: number, y: number, maxWidth?: number): void {
    const { weight, size, family } = readFont(this.font);
    // The offset that "middle" has in a canvas, about a third of the font size, for any SVG
    // renderer.
    const drop = this.textBaseline === "middle" ? size * 0.35 : 0;
    // In fonts that a user may have instead, no letter is wider than 0.7 of the font size.
    const isTight = maxWidth !== undefined && text.length * size * 0.7 > maxWidth;
    const squeezed = isTight
      ? ` textLength="${short(maxWidth)}" lengthAdjust="spacingAndGlyphs"`
      : "";
    this.#draw(
      `<text x="${short(x)}" y="${short(y + drop)}" text-anchor="${anchors[this.textAlign]}"` +
        `${attribute("font-family", family)} font-size="${short(size)}" font-weight="${weight}"` +
        `${squeezed}${this.#fillWith()}`,
      escapeText(text),
    );
  }

  #dataOf(path: Path2D | CanvasFillRule | undefined): string {
    return path === undefined || typeof path === "string"
      ? this.#path
      : escapeText(svgPathData(path));
  }

  #fillWith(): string {
    return attribute("fill", this.fillStyle);
  }

  /** @param start an element without its end */
  #draw(start: string, content?: string): void {
    const transform =
      this.#transform.length === 0 ? "" : ` transform="${this.#transform.join(" ")}"`;
    const end = content === undefined ? "/>" : `>${content}</text>`;
    this.#elements.push(start + transform + end);
  }
}

/**
 * Escapes text for element content and quoted attributes. Removes characters that XML does not
 * allow.
 */
export function escapeText(text: string): string {
  return text
    .replaceAll("&", "&amp;")
    .replaceAll("<", "&lt;")
    .replaceAll(">", "&gt;")
    .replaceAll('"', "&quot;")
    .toWellFormed()
    .replaceAll(/[^\t\n\r\u0020-\uD7FF\uE000-\uFFFD\u{10000}-\u{10FFFF}]/gu, "");
}

function attribute(name: string, value: Style): string {
  if (typeof value !== "string") throw new Error(`${name}: an SVG pen draws in plain colours`);
  return ` ${name}="${escapeText(value)}"`;
}

/** Parses a font such as "600 12px Inter, sans-serif". */
function readFont(font: string): { weight: string; size: number; family: string } {
  const [, weight = "400", size = "10", family = "sans-serif"] =
    /^(?:(\d+) )?([\d.]+)px (.*)$/s.exec(font) ?? [];
  return { weight, size: Number(size), family };
}

function short(number: number): string {
  return String(Math.round(number * 100) / 100);
}
