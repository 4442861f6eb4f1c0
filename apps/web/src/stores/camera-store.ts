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
}

export function createCameraStore() {
  return createStore<CameraState>()(() => ({ isDriving: false, isWhole: false }));
}
export type CameraStore = ReturnType<typeof createCameraStore>;
