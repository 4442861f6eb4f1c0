/** Marks over the maze: the walls around a goal, and the path of a wall follower that misses it. */
import type { Cell } from "@corridor/maze";
import { useStore } from "zustand";
import type { StageViewStore } from "../../../stage/page/stage-view.ts";
import { useServices } from "../../../model/use-services.ts";
import styles from "./wall-marks.module.css";

export function WallMarks({ view }: { view: StageViewStore }) {
  const { screen, workspace, run } = useServices();
  const marks = useStore(screen, ({ wallMarks }) => wallMarks);
  const maze = useStore(workspace, (state) => state.maze);
  const isPast = useStore(run, ({ pastMaze }) => pastMaze !== null);
  const layout = useStore(view, (state) => state.layout);
  // The marks of an earlier maze do not fit an edited one.
  if (!marks || marks.maze.blocks !== maze.blocks || isPast) return null;
  if (layout === null || layout.follows) return null;
  const { columns, rows, origin, cellPx } = layout;
  const loop = loopPath(marks.loop);
  return (
    <svg
      className={styles["marks"]}
      style={{ left: origin.x, top: origin.y, width: columns * cellPx, height: rows * cellPx }}
      viewBox={`0 0 ${columns} ${rows}`}
      data-marks
      aria-hidden="true"
    >
      <path
        className={styles["island"]}
        d={marks.island.map(({ column, row }) => `M${column} ${row}h1v1h-1z`).join("")}
      />
      <path className={styles["halo"]} d={loop} />
      <path className={styles["loop"]} d={loop} />
    </svg>
  );
}

/** Each step once: dashes of the way into a dead end and back would fill each other's gaps. */
function loopPath(loop: readonly Cell[]): string {
  const steps = new Set<string>();
  for (const [at, to] of loop.entries()) {
    const from = loop[at - 1];
    if (from === undefined) continue;
    const [first, second] = from.column + from.row < to.column + to.row ? [from, to] : [to, from];
    steps.add(
      `M${first.column + 0.5} ${first.row + 0.5}L${second.column + 0.5} ${second.row + 0.5}`,
    );
  }
  return [...steps].join("");
}
