/** Reads pages and straight lines from a PDF that Chromium printed. */
import { inflateSync } from "node:zlib";

type Matrix = readonly [number, number, number, number, number, number];

const identity: Matrix = [1, 0, 0, 1, 0, 0];

/** A line in PDF points (1/72 inch). */
export interface PdfLine {
  length: number;
  isHorizontal: boolean;
}

export interface PdfPage {
  /** in points */
  width: number;
  height: number;
}

/** Sizes of the pages. */
export function pagesOf(pdf: Buffer): PdfPage[] {
  const text = pdf.toString("latin1");
  const boxes = text.matchAll(/\/MediaBox\s*\[\s*([\d.]+) ([\d.]+) ([\d.]+) ([\d.]+)\s*\]/g);
  return [...boxes].map(([, left, bottom, right, top]) => ({
    width: Number(right) - Number(left),
    height: Number(top) - Number(bottom),
  }));
}

/** Straight lines of all pages, also those inside forms of a page. */
export function linesOf(pdf: Buffer): PdfLine[] {
  return streamsOf(pdf).flatMap(linesIn);
}

function streamsOf(pdf: Buffer): string[] {
  const text = pdf.toString("latin1");
  const found: string[] = [];
  for (const { index } of text.matchAll(/(?<!end)stream\r?\n/g)) {
    const start = text.indexOf("\n", index) + 1;
    const end = text.indexOf("endstream", start);
    try {
      found.push(inflateSync(pdf.subarray(start, end)).toString("latin1"));
    } catch {
      // Not compressed, or no stream of drawing operators.
    }
  }
  return found;
}

/** @param content drawing operators after their operands */
function linesIn(content: string): PdfLine[] {
  const lines: PdfLine[] = [];
  const stack: Matrix[] = [];
  let matrix = identity;
  let numbers: number[] = [];
  let at: readonly [number, number] = [0, 0];
  const placed = (x = 0, y = 0): readonly [number, number] => {
    const [a, b, c, d, e, f] = matrix;
    return [a * x + c * y + e, b * x + d * y + f];
  };
  for (const token of content.split(/\s+/)) {
    const number = Number(token);
    if (token !== "" && !Number.isNaN(number)) {
      numbers.push(number);
      continue;
    }
    if (token === "q") stack.push(matrix);
    else if (token === "Q") matrix = stack.pop() ?? identity;
    else if (token === "cm") matrix = product(numbers, matrix);
    else if (token === "m") at = placed(...numbers);
    else if (token === "l") {
      const next = placed(...numbers);
      const [dx, dy] = [next[0] - at[0], next[1] - at[1]];
      lines.push({ length: Math.hypot(dx, dy), isHorizontal: Math.abs(dy) < 0.01 });
      at = next;
    }
    numbers = [];
  }
  return lines;
}

function product([a = 1, b = 0, c = 0, d = 1, e = 0, f = 0]: number[], by: Matrix): Matrix {
  return [
    a * by[0] + b * by[2],
    a * by[1] + b * by[3],
    c * by[0] + d * by[2],
    c * by[1] + d * by[3],
    e * by[0] + f * by[2] + by[4],
    e * by[1] + f * by[3] + by[5],
  ];
}
