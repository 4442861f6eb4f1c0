/** The moves of a robot from cell to cell as a text such as e4s2, for the tile of a student. */
import { CELL } from "@corridor/maze";

/** Longest text: the newest moves fit into it. */
const MAX_LENGTH = 400;

/** @param positions of the robot's centre, x and y alternating, in units */
export function cellPath(positions: readonly number[]): string {
  const moves: { to: string; cells: number }[] = [];
  const move = (to: string, cells: number): void => {
    const last = moves.at(-1);
    if (last?.to === to) last.cells += cells;
    else if (cells > 0) moves.push({ to, cells });
  };
  let [column, row] = [cellAt(positions[0]), cellAt(positions[1])];
  for (let at = 2; at + 1 < positions.length; at += 2) {
    const next = [cellAt(positions[at]), cellAt(positions[at + 1])] as const;
    move(next[0] > column ? "e" : "w", Math.abs(next[0] - column));
    move(next[1] > row ? "s" : "n", Math.abs(next[1] - row));
    [column, row] = next;
  }
  let path = "";
  for (const { to, cells } of moves.toReversed()) {
    const longer = `${to}${cells}${path}`;
    if (longer.length > MAX_LENGTH) break;
    path = longer;
  }
  return path;
}

function cellAt(coordinate = 0): number {
  return Math.floor(coordinate / CELL);
}
