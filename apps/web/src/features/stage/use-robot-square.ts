/**
 * The robot's square and facing for the names of the squares, as "column,row,facing", "" before the first
 * frame. While the robot runs they follow once a second: a name that changes under the cursor is read out.
 */
import { useEffect, useState } from "react";
import { useServices } from "../../app/services.ts";
import type { RunState } from "../../stores/run-store.ts";
import { cellOf, facingOf } from "./robot-place.ts";

const CALM_MS = 1000;

export function useRobotSquare(): string {
  const { run } = useServices();
  const [square, setSquare] = useState(() => squareOf(run.getState()));
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const look = () => {
      timer = undefined;
      setSquare(squareOf(run.getState()));
    };
    look();
    const end = run.subscribe(({ snapshot }, before) => {
      if (snapshot === before.snapshot) return;
      if (snapshot?.state === "running") timer ??= setTimeout(look, CALM_MS);
      else {
        clearTimeout(timer);
        look();
      }
    });
    return () => {
      clearTimeout(timer);
      end();
    };
  }, [run]);
  return square;
}

function squareOf({ snapshot }: RunState): string {
  if (snapshot === null) return "";
  const { column, row } = cellOf(snapshot.pose);
  return `${column},${row},${facingOf(snapshot.pose.heading)}`;
}
