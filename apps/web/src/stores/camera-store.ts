/**
 * How the stage looks at the maze. While a phone's Drive tab is open nobody edits: a camera goes with the
 * robot, or the whole maze shows.
 */
import { createStore } from "zustand/vanilla";

export interface CameraState {
  /** whether the phone's Drive tab is open: no tools, no transport, the robot has the stage */
  isDriving: boolean;
  /** whether the reader wants to see the whole maze while driving */
  isWhole: boolean;
  /** zooms the stage, around a pixel of its view or around the robot; does nothing while there is no stage */
  zoom: (
    by: "in" | "out" | "fit" | { factor: number },
    at: { x: number; y: number } | null,
  ) => void;
}

export function createCameraStore() {
  return createStore<CameraState>()(() => ({ isDriving: false, isWhole: false, zoom: () => {} }));
}
export type CameraStore = ReturnType<typeof createCameraStore>;
