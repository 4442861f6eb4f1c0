/**
 * Messages cover the lower or the upper edge of the stage. The root element has the robot's side as
 * an attribute, so that messages use the other edge (messages.module.css).
 */
import { viewportAt, viewX, viewY } from "../../stage/drawing/viewport.ts";
import type { RunStore } from "../../model/run/run-store.ts";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import { ROBOT_HALF } from "../../ui/robot-outline.ts";

/** How far a message extends into the drawing area, and to either side of its middle, in px. */
const REACH = { upper: 120, lower: 112, aside: 320 };

export type RobotSide = "upper" | "lower" | null;

/** @param robot its middle and half its width, in px of the drawing area */
export function robotSide(
  robot: { x: number; y: number; half: number },
  area: { width: number; height: number },
): RobotSide {
  if (Math.abs(robot.x - area.width / 2) - robot.half > REACH.aside) return null;
  if (robot.y + robot.half > area.height - REACH.lower) return "lower";
  return robot.y - robot.half < REACH.upper ? "upper" : null;
}

/** @returns a function that stops the updates */
export function publishRobotSide(view: StageViewStore, run: RunStore): () => void {
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
