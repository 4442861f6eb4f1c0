/**
 * The whole maze in small, with the robot in it and a frame around the part that shows: drawn when the maze
 * changes; the robot is moved on it as often as the panel is told of it. A picture for the eye: the grid
 * tells all of it. Where the stage is scrolled, a press on the map brings that part into view.
 */
import { sizeOf } from "@corridor/maze";
import { useEffect, useRef, type PointerEvent } from "react";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import {
  CELL,
  viewX,
  viewY,
  viewportAt,
  centredScroll,
  type Scroll,
} from "../../canvas/viewport.ts";
import { RobotFace } from "../../ui/RobotFace.tsx";
import { MazePicture } from "../presets/MazePicture.tsx";
import styles from "./camera-view.module.css";
import { hasMapRoom, mapSide } from "./map-side.ts";
import type { StageViewStore } from "./stage-view.ts";

/** The picture's longer side, in CSS pixels. */
const LONGEST_PX = 96;
const ROBOT_PX = 12;
/** Around the picture: padding and border, on both sides together. */
const FRAME_PX = 10;

interface SmallMapProps {
  view: StageViewStore;
  /** scrolls the stage; none where a camera goes with the robot */
  onScroll?: (scroll: Scroll) => void;
}

export function SmallMap({ view, onScroll }: SmallMapProps) {
  const { workspace, run } = useServices();
  const ownMaze = useStore(workspace, (state) => state.maze);
  const maze = useStore(run, ({ pastMaze: shownMaze }) => shownMaze) ?? ownMaze;
  const { columns, rows } = sizeOf(maze);
  const scale = LONGEST_PX / Math.max(columns, rows);
  const picture = { width: columns * scale, height: rows * scale };
  const map = { width: picture.width + FRAME_PX, height: picture.height + FRAME_PX };
  const side = useSide(view, map);
  const hasRoom = useStore(view, ({ layout }) => layout !== null && hasMapRoom(layout.view, map));
  const robot = useRef<HTMLDivElement>(null);
  const look = (event: PointerEvent<HTMLDivElement>): void => {
    const { layout } = view.getState();
    if (layout === null || onScroll === undefined) return;
    if (event.type === "pointerdown") event.currentTarget.setPointerCapture(event.pointerId);
    else if (event.buttons === 0) return;
    const { left, top } = event.currentTarget.getBoundingClientRect();
    const unitsPerPixel = CELL / scale;
    const [x, y] = [event.clientX - left, event.clientY - top];
    onScroll(centredScroll(layout, x * unitsPerPixel, y * unitsPerPixel));
  };
  useEffect(() => {
    const place = ({ snapshot } = run.getState()): void => {
      if (robot.current === null || snapshot === null) return;
      const { x, y, heading } = snapshot.pose;
      const [left, top] = [x, y].map((at) => `${(at / CELL) * scale}px`);
      robot.current.style.transform = `translate(${left}, ${top}) rotate(${heading}deg)`;
    };
    place();
    return run.subscribe(place);
  }, [run, scale, hasRoom]);
  if (!hasRoom) return null;
  return (
    <div
      className={styles["map"]}
      data-side={side}
      data-map=""
      data-pressed={onScroll !== undefined}
      aria-hidden="true"
    >
      <div
        className={styles["picture"]}
        style={picture}
        onPointerDown={look}
        onPointerMove={look}
        onPointerUp={look}
      >
        <MazePicture maze={maze} showStart={false} />
        {onScroll !== undefined && <VisiblePart view={view} scale={scale} />}
        <div ref={robot} className={styles["robot"]}>
          <RobotFace size={ROBOT_PX} />
        </div>
      </div>
    </div>
  );
}

/** A frame around the part of the maze that the stage shows. */
function VisiblePart({ view, scale }: { view: StageViewStore; scale: number }) {
  const layout = useStore(view, (state) => state.layout);
  const scroll = useStore(view, (state) => state.scroll);
  if (layout === null) return null;
  const { origin, port, cellPx } = layout;
  const shrink = scale / cellPx;
  const along = (at: number, room: number, cells: number) => {
    const from = Math.max(0, at * shrink);
    return { from, length: Math.min(cells * scale, (at + room) * shrink) - from };
  };
  const x = along(port.x - origin.x + scroll.x, port.width, layout.columns);
  const y = along(port.y - origin.y + scroll.y, port.height, layout.rows);
  return (
    <div
      className={styles["part"]}
      style={{ left: x.from, top: y.from, width: x.length, height: y.length }}
    />
  );
}

/** The lower corner that the robot is not in. */
function useSide(view: StageViewStore, map: { width: number; height: number }) {
  const { run } = useServices();
  const layout = useStore(view, (state) => state.layout);
  return useStore(run, ({ snapshot }) => {
    if (layout === null || snapshot === null) return "left";
    const { x, y } = snapshot.pose;
    const camera = layout.follows ? centredScroll(layout, x, y) : view.getState().scroll;
    const viewport = viewportAt(layout, camera);
    return mapSide({ x: viewX(viewport, x), y: viewY(viewport, y) }, layout.view, map);
  });
}
