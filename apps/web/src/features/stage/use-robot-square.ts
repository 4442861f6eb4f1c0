/**
 * The robot's square and facing for the names of the squares, as "column,row,facing", "" before the first
 * frame. While the robot runs they follow once a second: a name that changes under the cursor is read out.
 */
import { useEffect, useState } from "react";
import { useServices } from "../../app/services.ts";
import type { RunState } from "../../stores/run-store.ts";
import { CalmPace } from "../../ui/calm-pace.ts";
import { cellOf, facingOf } from "./robot-place.ts";

export function useRobotSquare(): string {
  const { run } = useServices();
  const [square, setSquare] = useState(() => squareOf(run.getState()));
  useEffect(() => {
    // Told with a frame of the run, never by a timer between two: each drawing of the page costs.
    const pace = new CalmPace<null>(() => performance.now());
    const look = (state: RunState) => {
      if (pace.isDue(state.snapshot?.state === "running", null)) setSquare(squareOf(state));
    };
    look(run.getState());
    return run.subscribe(look);
  }, [run]);
  return square;
}

function squareOf({ snapshot }: RunState): string {
  if (snapshot === null) return "";
  const { column, row } = cellOf(snapshot.pose);
  return `${column},${row},${facingOf(snapshot.pose.heading)}`;
}
