/**
 * Messages lie over the lower or the upper edge of the stage: the root says at which of them the robot is, so
 * that they keep to the other one (messages.module.css).
 */
import { viewportAt, viewX, viewY } from "../../canvas/viewport.ts";
import type { RunStore } from "../../stores/run-store.ts";
import type { StageViewStore } from "./stage-view.ts";

/** How far a message reaches into the drawing area, and to either side of its middle, in px. */
const REACH = { upper: 120, lower: 112, aside: 320 };
/** Half of the robot's width as it is drawn, in units. */
const ROBOT_HALF = 28;

export type RobotSide = "upper" | "lower" | null;

/** @param robot the middle and half the width of the robot, in px of the drawing area */
export function robotSide(
  robot: { x: number; y: number; half: number },
  area: { width: number; height: number },
): RobotSide {
  if (Math.abs(robot.x - area.width / 2) - robot.half > REACH.aside) return null;
  if (robot.y + robot.half > area.height - REACH.lower) return "lower";
  return robot.y - robot.half < REACH.upper ? "upper" : null;
}

/** @returns a function that ends it */
export function tellRobotSide(view: StageViewStore, run: RunStore): () => void {
  const { dataset } = document.documentElement;
  const look = (): void => {
    const { layout, scroll } = view.getState();
    const pose = run.getState().snapshot?.pose;
    if (layout === null || pose === undefined) return;
    const viewport = viewportAt(layout, scroll);
    const robot = {
      x: viewX(viewport, pose.x),
      y: viewY(viewport, pose.y),
      half: ROBOT_HALF * viewport.scale,
    };
    const side = robotSide(robot, layout.view);
    if (dataset["robotIn"] === (side ?? undefined)) return;
    if (side === null) delete dataset["robotIn"];
    else dataset["robotIn"] = side;
  };
  const stops = [view.subscribe(look), run.subscribe(look)];
  return () => {
    for (const stop of stops) stop();
    delete dataset["robotIn"];
  };
}
