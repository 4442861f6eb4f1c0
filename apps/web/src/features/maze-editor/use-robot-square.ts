/**
 * The robot's square and facing for the labels of the squares around the cursor, as
 * "column,row,facing". "" before the first frame and while the robot is elsewhere, which avoids
 * renders. Updates at most once a second during a run, because screen readers read a changed label.
 */
import type { Cell } from "@corridor/maze";
import { useEffect, useState } from "react";
import { useServices } from "../../model/use-services.ts";
import type { RunState } from "../../model/run/run-store.ts";
import { Throttle } from "../../ui/throttle.ts";
import { isAround } from "./grid-cursor.ts";
import { cellOf, facingOf } from "../../stage/page/robot-place.ts";

export function useRobotSquare({ column, row }: Cell): string {
  const { run } = useServices();
  const [square, setSquare] = useState(() => robotSquare(run.getState()));
  useEffect(() => {
    // Updates with a frame of the run instead of a timer, to avoid additional renders.
    const pace = new Throttle<null>(() => performance.now());
    const look = (state: RunState) => {
      if (!pace.isDue(state.snapshot?.state === "running", null)) return;
      const isNear =
        state.snapshot !== null && isAround({ column, row }, cellOf(state.snapshot.pose));
      setSquare(isNear ? robotSquare(state) : "");
    };
    look(run.getState());
    return run.subscribe(look);
  }, [run, column, row]);
  return square;
}

/** The robot's current square and facing: "column,row,facing", or "" before the first frame. */
export function robotSquare({ snapshot }: RunState): string {
  if (snapshot === null) return "";
  const { column, row } = cellOf(snapshot.pose);
  return `${column},${row},${facingOf(snapshot.pose.heading)}`;
}
