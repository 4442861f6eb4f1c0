/** The colours of cells, by their letters in commands. */

import type { MarkColor } from "@corridor/protocol";

const colors = {
  k: "black",
  b: "blue",
  a: "gray",
  c: "cyan",
  g: "green",
  o: "orange",
  r: "red",
  w: "white",
  y: "yellow",
  B: "dark-blue",
  C: "dark-cyan",
  A: "dark-gray",
  G: "dark-green",
  O: "dark-orange",
  R: "dark-red",
  V: "dark-violet",
  Y: "dark-yellow",
} as const satisfies Record<string, MarkColor>;
/** The letter of a colour in commands. */
export type ColorLetter = keyof typeof colors;

export function isColorLetter(letter: string): letter is ColorLetter {
  return Object.hasOwn(colors, letter);
}

export function colorOf(letter: ColorLetter): MarkColor {
  return colors[letter];
}
