/**
 * The whole maze in small, with the robot and a frame around the visible part. The maze is drawn
 * when it changes; the robot moves with each snapshot of the run store. Hidden from screen readers,
 * because the grid contains the same information. Where the stage scrolls, a press on the map
 * scrolls to that part.
 */
import { CELL, sizeOf } from "@corridor/maze";
import { useEffect, useRef, type PointerEvent } from "react";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import {
  viewX,
  viewY,
  viewportAt,
  centredScroll,
  type Scroll,
} from "../../stage/drawing/viewport.ts";
import { RobotFace } from "../../ui/RobotFace.tsx";
import { MazePicture } from "../../ui/MazePicture.tsx";
import styles from "./camera-view.module.css";
import { hasMapRoom, mapSide } from "./map-side.ts";
import type { StageViewStore } from "../../stage/page/stage-view.ts";

/** Longer side of the map, in CSS pixels. */
const LONGEST_PX = 96;
const ROBOT_PX = 12;
/** Padding and border of both sides together, in CSS pixels. */
const FRAME_PX = 10;

interface SmallMapProps {
  view: StageViewStore;
  /** scrolls the stage; undefined while a camera follows the robot */
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

/** A frame around the visible part of the maze. */
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

/** The lower corner of the stage that does not contain the robot. */
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
