/**
 * Camera of the stage. While the Drive tab of a phone is open, nobody edits: the stage follows the
 * robot or shows the whole maze.
 */
import { createStore } from "zustand/vanilla";

export interface CameraState {
  /** whether the Drive tab of a phone is open, which hides tools and transport */
  isDriving: boolean;
  /** whether the user wants to see the whole maze while driving */
  isWhole: boolean;
  /**
   * zooms the stage around a pixel of its view or, for null, around the robot; does nothing without
   * a stage
   */
  zoom: (
    by: "in" | "out" | "fit" | { factor: number },
    at: { x: number; y: number } | null,
  ) => void;
}

export function createCameraStore() {
  return createStore<CameraState>()(() => ({ isDriving: false, isWhole: false, zoom: () => {} }));
}
export type CameraStore = ReturnType<typeof createCameraStore>;
