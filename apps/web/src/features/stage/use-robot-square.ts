/**
 * The robot's square and facing for the names of the squares around the cursor, as "column,row,facing"; ""
 * before the first frame, and while the robot is elsewhere, so that nothing is drawn again then. While it
 * runs they follow once a second: a name that changes under the cursor is read out.
 */
import type { Cell } from "@corridor/maze";
import { useEffect, useState } from "react";
import { useServices } from "../../app/services.ts";
import type { RunState } from "../../stores/run-store.ts";
import { Throttle } from "../../ui/throttle.ts";
import { isAround } from "./grid-cursor.ts";
import { cellOf, facingOf } from "./robot-place.ts";

export function useRobotSquare({ column, row }: Cell): string {
  const { run } = useServices();
  const [square, setSquare] = useState(() => robotSquare(run.getState()));
  useEffect(() => {
    // Told with a frame of the run, never by a timer between two: each drawing of the page costs.
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

/** The robot's square and facing now, wherever it is: "column,row,facing", "" before the first frame. */
export function robotSquare({ snapshot }: RunState): string {
  if (snapshot === null) return "";
  const { column, row } = cellOf(snapshot.pose);
  return `${column},${row},${facingOf(snapshot.pose.heading)}`;
}
