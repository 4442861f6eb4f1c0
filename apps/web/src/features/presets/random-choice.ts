/**
 * The random maze that the user is choosing. The choice outlives the panel, so that a reopened menu
 * displays the same maze.
 */
import type { MazeKind } from "@corridor/maze";
import { createStore } from "zustand/vanilla";

/**
 * Sides that the slider offers, odd numbers only. A link to the largest maze still opens on a
 * phone.
 */
export const LEAST_SIDE = 5;
export const MOST_SIDE = 101;

/**
 * Largest seed that can be typed. Drawn seeds are smaller: short enough to be called across a room.
 */
export const MOST_SEED = 999_999_999;
const DRAWN_SEEDS = 9_999;

interface RandomChoice {
  kind: MazeKind;
  /** columns and rows, odd */
  side: number;
  seed: number;
}

export const randomChoice = createStore<RandomChoice>()(() => ({
  kind: "tree",
  side: 21,
  seed: drawSeed(),
}));

/** A random seed from 1 to 9999. */
export function drawSeed(): number {
  const [word = 0] = crypto.getRandomValues(new Uint32Array(1));
  return (word % DRAWN_SEEDS) + 1;
}
