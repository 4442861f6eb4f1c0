/**
 * The whole maze in small, with the robot in it: drawn when the maze changes; the robot is moved on it as
 * often as the panel is told of it. A picture for the eye: the grid tells all of it.
 */
import { sizeOf } from "@corridor/maze";
import { useEffect, useRef } from "react";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { CELL, viewX, viewY, viewportAt, centredScroll } from "../../canvas/viewport.ts";
import { RobotFace } from "../../ui/RobotFace.tsx";
import { MazePicture } from "../presets/MazePicture.tsx";
import styles from "./camera-view.module.css";
import type { StageViewStore } from "./stage-view.ts";

/** The picture's longer side, in CSS pixels. */
const LONGEST_PX = 96;
const ROBOT_PX = 12;
/** A robot that is so near to the map's corner, as shares of the view, would stand under it. */
const NEAR_X = 0.45;
const NEAR_Y = 0.5;

export function SmallMap({ view }: { view: StageViewStore }) {
  const { workspace, run } = useServices();
  const ownMaze = useStore(workspace, (state) => state.maze);
  const maze = useStore(run, ({ shownMaze }) => shownMaze) ?? ownMaze;
  const { columns, rows } = sizeOf(maze);
  const scale = LONGEST_PX / Math.max(columns, rows);
  const side = useSide(view);
  const robot = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const place = ({ snapshot } = run.getState()): void => {
      if (robot.current === null || snapshot === null) return;
      const { x, y, heading } = snapshot.pose;
      const [left, top] = [x, y].map((at) => `${(at / CELL) * scale}px`);
      robot.current.style.transform = `translate(${left}, ${top}) rotate(${heading}deg)`;
    };
    place();
    return run.subscribe(place);
  }, [run, scale]);
  return (
    <div className={styles["map"]} data-side={side} data-map="" aria-hidden="true">
      <div className={styles["picture"]} style={{ width: columns * scale, height: rows * scale }}>
        <MazePicture maze={maze} showStart={false} />
        <div ref={robot} className={styles["robot"]}>
          <RobotFace size={ROBOT_PX} />
        </div>
      </div>
    </div>
  );
}

/** The lower corner that the robot is not in: left and right as in the maze, in every language. */
function useSide(view: StageViewStore): "left" | "right" {
  const { run } = useServices();
  const layout = useStore(view, (state) => state.layout);
  return useStore(run, ({ snapshot }) => {
    if (layout === null || snapshot === null) return "left";
    const { x, y } = snapshot.pose;
    const viewport = viewportAt(layout, centredScroll(layout, x, y));
    const { width, height } = layout.view;
    const isNear = viewX(viewport, x) / width < NEAR_X;
    const isLow = viewY(viewport, y) / height > NEAR_Y;
    return isLow && isNear ? "right" : "left";
  });
}
