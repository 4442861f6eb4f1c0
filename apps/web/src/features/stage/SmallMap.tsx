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
import { mapSide } from "./map-side.ts";
import type { StageViewStore } from "./stage-view.ts";

/** The picture's longer side, in CSS pixels. */
const LONGEST_PX = 96;
const ROBOT_PX = 12;
/** Around the picture: padding and border, on both sides together. */
const FRAME_PX = 10;

export function SmallMap({ view }: { view: StageViewStore }) {
  const { workspace, run, numbersRun } = useServices();
  const ownMaze = useStore(workspace, (state) => state.maze);
  const maze = useStore(run, ({ shownMaze }) => shownMaze) ?? ownMaze;
  const { columns, rows } = sizeOf(maze);
  const scale = LONGEST_PX / Math.max(columns, rows);
  const picture = { width: columns * scale, height: rows * scale };
  const side = useSide(view, picture);
  const robot = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const place = ({ snapshot } = numbersRun.getState()): void => {
      if (robot.current === null || snapshot === null) return;
      const { x, y, heading } = snapshot.pose;
      const [left, top] = [x, y].map((at) => `${(at / CELL) * scale}px`);
      robot.current.style.transform = `translate(${left}, ${top}) rotate(${heading}deg)`;
    };
    place();
    return numbersRun.subscribe(place);
  }, [numbersRun, scale]);
  return (
    <div className={styles["map"]} data-side={side} data-map="" aria-hidden="true">
      <div className={styles["picture"]} style={picture}>
        <MazePicture maze={maze} showStart={false} />
        <div ref={robot} className={styles["robot"]}>
          <RobotFace size={ROBOT_PX} />
        </div>
      </div>
    </div>
  );
}

/** The lower corner that the robot is not in. */
function useSide(view: StageViewStore, picture: { width: number; height: number }) {
  const { run } = useServices();
  const layout = useStore(view, (state) => state.layout);
  const map = { width: picture.width + FRAME_PX, height: picture.height + FRAME_PX };
  return useStore(run, ({ snapshot }) => {
    if (layout === null || snapshot === null) return "left";
    const { x, y } = snapshot.pose;
    const viewport = viewportAt(layout, centredScroll(layout, x, y));
    return mapSide({ x: viewX(viewport, x), y: viewY(viewport, y) }, layout.view, map);
  });
}
